# SPDX-License-Identifier: Apache-2.0
"""slamicp-bench, on a small simulated set. SLAMICP names the program to test; only built with SLAMICP_BUILD_BENCH."""
import csv
import json
import math
import random
import unittest

from command import CommandTest

WALLS = [((0.0, 0.0), (6.0, 0.0)), ((6.0, 0.0), (6.0, 2.0)), ((6.0, 2.0), (4.0, 2.0)), ((4.0, 2.0), (4.0, 4.5)),
         ((4.0, 4.5), (0.0, 4.5)), ((0.0, 4.5), (0.0, 0.0))]
UNMAPPED = [((2.9, 2.2), (2.9, 2.5)), ((2.9, 2.5), (2.6, 2.5)), ((2.6, 2.5), (2.6, 2.2)), ((2.6, 2.2), (2.9, 2.2))]
BEAMS = 541
SCANS = 6
KEYS = {"name", "what", "process", "samples", "median_us", "p99_us", "ratio_to_ours", "prepare_ms", "iterations", "scans",
        "failures", "error_mm", "rotation_deg", "outliers_mean", "outlier_agreement", "outlier_point_agreement"}
OURS = ["ours_pose", "ours_outliers", "ours_all"]
AGENTS = ["original", "original_rebuilt", "original_vectorized", "original_first_near", "improved", "improved_rebuilt"]
FILES = ("--map", "map.csv", "--ranges", "ranges.csv", "--poses", "poses.csv")


def seen(pose, angle, segments):
    """How far a beam goes."""
    x, y, theta = pose
    dx, dy = math.cos(theta + angle), math.sin(theta + angle)
    nearest = math.inf
    for (ax, ay), (bx, by) in segments:
        ex, ey = bx - ax, by - ay
        slope = dx * ey - dy * ex
        if slope == 0.0:
            continue
        distance = ((ax - x) * ey - (ay - y) * ex) / slope
        share = ((ax - x) * dy - (ay - y) * dx) / slope
        if distance > 0.0 and 0.0 <= share <= 1.0:
            nearest = min(nearest, distance)
    return nearest


class Bench(CommandTest):
    def setUp(self):
        super().setUp()
        draw = random.Random(1)
        points = []
        for (ax, ay), (bx, by) in WALLS:
            steps = round(100 * math.hypot(bx - ax, by - ay))
            points += [f"{ax + k / steps * (bx - ax)},{ay + k / steps * (by - ay)}" for k in range(steps)]
        self.map_points = len(points)
        ranges, poses, hits = [], ["truth_x,truth_y,truth_th,guess_x,guess_y,guess_th"], 0
        for scan in range(SCANS):
            truth = (1.0 + 0.1 * scan, 1.0 + 0.05 * scan, 0.2 * scan)
            guess = (truth[0] + draw.uniform(-0.05, 0.05), truth[1] + draw.uniform(-0.05, 0.05), truth[2] + 0.02)
            poses.append(",".join(map(str, truth + guess)))
            angles = [math.radians(-135.0 + 270.0 * k / (BEAMS - 1)) for k in range(BEAMS)]
            wall = [seen(truth, angle, WALLS) for angle in angles]
            thing = [seen(truth, angle, UNMAPPED) for angle in angles]
            hits += sum(a < b for a, b in zip(thing, wall))
            ranges.append(",".join(f"{min(pair):.6f}" for pair in zip(wall, thing)))
        self.outliers_a_scan = hits / SCANS
        self.write("map.csv", "\n".join(points) + "\n")
        self.write("ranges.csv", "\n".join(ranges) + "\n")
        self.write("poses.csv", "\n".join(poses) + "\n")

    def test_all_contenders_run_or_are_named_as_missing(self):
        told = self.summary(*FILES, "--rounds", "2", "--block", "2")
        self.assertEqual((told["scene"]["map_points"], told["scene"]["scans"]), (self.map_points, SCANS))
        self.assertEqual(set(told["machine"]), {"cpu", "vectors", "cores", "compiler", "flags", "date"})
        rows = {row["name"]: row for row in told["contenders"]}
        missing = {peer["name"] for peer in told["missing"]}
        self.assertEqual([name for name in rows if not name.startswith('by_')][:9], OURS + AGENTS)
        for peer in ("pcl", "mrpt"):
            self.assertEqual(peer in missing, not any(name.startswith(peer) for name in rows))
        for name, row in rows.items():
            self.assertEqual(set(row), KEYS, name)
            self.assertEqual((row["samples"], row["scans"], row["failures"]), (2 * SCANS, SCANS, 0), name)
            self.assertEqual(row["process"], "this")
            self.assertLessEqual(row["error_mm"]["mean"], row["error_mm"]["max"])
        self.assertEqual(rows["ours_outliers"]["ratio_to_ours"], 1.0)

    def test_outliers_are_those_of_brute_force(self):
        told = self.summary(*FILES, "--rounds", "1", "--only", "ours,original,improved")
        rows = {row["name"]: row for row in told["contenders"]}
        self.assertEqual(list(rows), OURS + ["original", "improved"])
        self.assertIsNone(rows.pop("ours_pose")["outliers_mean"])
        self.assertGreater(self.outliers_a_scan, 5)
        for name, row in rows.items():
            self.assertEqual((row["outlier_agreement"], row["outlier_point_agreement"]), (1.0, 1.0), name)
            self.assertAlmostEqual(row["outliers_mean"], self.outliers_a_scan, msg=name)

    def test_peers_of_the_same_scene_join(self):
        told = self.summary(*FILES, "--rounds", "1", "--only", "improved")
        told["contenders"][0] |= {"name": "elsewhere", "iterations": None}
        told["missing"] = [{"name": "absent", "why": "no wheel", "mend": "pip install it"}]
        self.write("peers.json", json.dumps(told))
        both = self.summary(*FILES, "--rounds", "1", "--only", "ours_outliers", "--peers", "peers.json")
        other = both["contenders"][1]
        self.assertEqual((other["name"], other["process"]), ("elsewhere", "another"))
        self.assertAlmostEqual(other["ratio_to_ours"] * both["contenders"][0]["median_us"], other["median_us"])
        self.assertEqual(both["missing"], told["missing"])
        shown = self.done(*FILES, "--rounds", "1", "--only", "ours_outliers", "--peers", "peers.json").stdout
        for text in ("elsewhere *", "measured in another process", "missing: absent: no wheel; pip install it"):
            self.assertIn(text, shown)
        self.could_not(*FILES, "--scans", "3", "--peers", "peers.json", says=("another scene", "peers.json"))
        self.write("peers.json", "{}")
        self.could_not(*FILES, "--peers", "peers.json", says=("peers.json", "bench/peers.py"))

    def test_a_sweep_is_seeded(self):
        words = ("sweep", "layout", "--scans", "6", "--rounds", "1", "--only", "ours_outliers,improved")
        told, again = self.summary(*words, "--csv", "layout.csv"), self.summary(*words)
        other = self.summary(*words, "--seed", "2")
        self.assertEqual([setting["label"] for setting in told["settings"]], ["corridor", "office", "hall"])
        for setting, same, differing in zip(told["settings"], again["settings"], other["settings"]):
            errors = [row["error_mm"] for row in setting["contenders"]]
            self.assertEqual(errors, [row["error_mm"] for row in same["contenders"]])
            self.assertNotEqual(errors, [row["error_mm"] for row in differing["contenders"]])
            self.assertAlmostEqual(setting["map_points"], 2e4, delta=500)
        rows = list(csv.DictReader(self.read("layout.csv").splitlines()))
        self.assertEqual([(row["label"], row["contender"]) for row in rows][:2],
                         [("corridor", "ours_outliers"), ("corridor", "improved")])
        self.assertEqual(len(rows), 6)

    def test_broken_input_is_told_with_its_place(self):
        self.could_not("--map", "nowhere.csv", *FILES[2:], says=("nowhere.csv",))
        self.could_not(*FILES[:4], "--poses", "nowhere.csv", says=("nowhere.csv", "truth_x"))
        lines = self.read("poses.csv").splitlines()
        for broken, problem in (("1,2,x,4,5,6", "'x' is not a number"), ("1,2,3", "3 values, not 6")):
            self.write("broken.csv", "\n".join([*lines[:2], broken, *lines[3:]]))
            self.could_not(*FILES[:4], "--poses", "broken.csv", says=("broken.csv:3", problem))
        self.write("short.csv", "\n".join(lines[:-1]))
        self.could_not(*FILES[:4], "--poses", "short.csv", says=("5 poses, but 6 scans", "short.csv"))
        self.write("empty.csv", "")
        self.could_not("--map", "empty.csv", *FILES[2:], says=("empty.csv",))

    def test_wrong_words(self):
        self.wrong_words(*FILES, "--only", "nobody", says=("no contender 'nobody'", "ours_pose"))
        self.wrong_words(*FILES, "--scans", "-1", says=("--scans",))
        self.wrong_words(*FILES, "--rounds", "0", says=("--rounds",))
        self.wrong_words("--no-such-option")
        self.wrong_words("sweep", "weather", says=("map-size",))

    def could_not(self, *words, says=()):
        return self.fails(1, *words, says=("slamicp-bench: ", *says))


if __name__ == "__main__":
    unittest.main()
