# SPDX-License-Identifier: Apache-2.0
"""slamicp simulate, and what follows from it: localize, map, Ctrl-C."""
import json
import math
import os
import signal
import subprocess
import time
import unittest

from command import (CommandTest, METRICS_HEADER, OBSTACLES_HEADER, OUTLIERS_HEADER, PROGRAM, moved, pose_words)

STOPS = {"converged", "max_iterations", "degenerate", "too_few_points", "no_overlap"}


class Simulate(CommandTest):
    def simulate(self, prefix, *words):
        return self.summary("simulate", "--out", prefix + ".clf", "--truth", prefix + ".tum", "--map-out",
                            prefix + ".csv", "--speed", "3", "--obstacle", "C2", *words)

    def test_the_same_seed_gives_the_same_bytes(self):
        self.simulate("a", "--seed", "7")
        self.simulate("b", "--seed", "7")
        self.simulate("c", "--seed", "8")
        for ending in (".clf", ".tum", ".csv"):
            first = (self.folder / ("a" + ending)).read_bytes()
            self.assertEqual(first, (self.folder / ("b" + ending)).read_bytes())
            if ending != ".tum":  # the way is the same, the noise is not
                self.assertNotEqual(first, (self.folder / ("c" + ending)).read_bytes())

    def test_summary_is_true(self):
        told = self.simulate("a")
        truth = self.trajectory("a.tum")
        self.assertEqual(told["scans"], len(truth))
        self.assertEqual(told["map_points"], len(self.numbers("a.csv")))
        start = told["initial_pose"]
        for mine, theirs in zip(truth[0][1:], (start["x"], start["y"], start["theta"])):
            self.assertAlmostEqual(mine, theirs, places=5)
        info = self.summary("info", "a.clf")
        self.assertEqual(info["scans"], told["scans"])
        self.assertEqual(info["beams"], [1081])
        self.assertAlmostEqual(info["fov_deg"], 270.0, places=3)


class Localize(CommandTest):
    def setUp(self):
        super().setUp()
        self.start = self.summary("simulate", "--out", "run.clf", "--truth", "truth.tum", "--map-out", "map.csv",
                                  "--obstacle", "A1", "--speed", "1.5")
        self.pose = pose_words(self.start["initial_pose"])

    def test_a_simulated_run_is_localized_to_millimetres_and_every_file_is_as_promised(self):
        told = self.summary("localize", "run.clf", "--map", "map.csv", "--initial-pose", self.pose, "--trajectory",
                            "run.tum", "--outliers", "outliers.csv", "--obstacles", "obstacles.csv", "--metrics",
                            "metrics.csv", "--update-map", "updated.pcd", "--report", "report.html")
        scans = self.start["scans"]
        self.assertEqual(told["scans"], scans)
        self.assertEqual(sum(told["stops"].values()), scans)

        truth, run = self.trajectory("truth.tum"), self.trajectory("run.tum")
        self.assertEqual([pose[0] for pose in run], [pose[0] for pose in truth])
        metrics = self.table("metrics.csv", METRICS_HEADER)
        self.assertEqual([int(row["scan"]) for row in metrics], list(range(scans)))
        for row, pose in zip(metrics, run):
            self.assertIn(row["stop"], STOPS)
            self.assertAlmostEqual(float(row["x"]), pose[1], places=5)
            self.assertAlmostEqual(float(row["theta"]), pose[3], places=5)
        outliers = self.table("outliers.csv", OUTLIERS_HEADER)
        for row in outliers:
            self.assertIn(row["kind"], ("obstacle", "gone", "unmapped", "unknown"))
            self.assertLess(int(row["beam"]), 1081)
            self.assertGreaterEqual(float(row["distance"]), 0.3)
        self.assertEqual(len(outliers), sum(int(row["outliers"]) for row in metrics))
        for row in self.table("obstacles.csv", OBSTACLES_HEADER):
            self.assertGreater(float(row["radius"]), 0.0)
        self.assertEqual(self.summary("info", "updated.pcd")["points"], self.start["map_points"] + len(outliers))
        self.assertTrue(self.read("report.html").rstrip().endswith("</html>"))

    def test_errors_are_below_5_mm_and_the_obstacle_is_where_it_stands(self):
        self.done("localize", "run.clf", "--map", "map.csv", "--initial-pose", self.pose, "--trajectory", "run.tum",
                  "--outlier-distance", "0.1", "--obstacles", "obstacles.csv")
        error = self.summary("evaluate", "run.tum", "--truth", "truth.tum")["absolute"]
        self.assertEqual(error["unmatched"], 0)
        self.assertLess(error["translation"]["mean"], 0.005)
        self.assertLess(error["translation"]["max"], 0.03)
        largest = max(self.table("obstacles.csv", OBSTACLES_HEADER), key=lambda row: int(row["points"]))
        self.assertLess(math.hypot(float(largest["x"]) - 9.0, float(largest["y"]) - 0.3), 0.3)
        # The same one from scan to scan, and it stands.
        of_it = [row for row in self.table("obstacles.csv", OBSTACLES_HEADER) if row["id"] == largest["id"]]
        self.assertGreater(len(of_it), 40)
        self.assertEqual({row["state"] for row in of_it}, {"tentative", "undecided", "static"})
        self.assertEqual({float(row["speed"]) for row in of_it}, {0.0})

    def test_the_obstacle_distance_decides_obstacles_and_leaves_outliers(self):
        words = ("localize", "run.clf", "--map", "map.csv", "--initial-pose", self.pose)
        by_noise = self.summary(*words, "--obstacles", "obstacles.csv", "--outliers", "outliers.csv")
        far = self.summary(*words, "--obstacles", "far.csv", "--obstacle-distance", "0.6")
        self.assertEqual(by_noise["outliers_mean"], far["outliers_mean"])
        points = [sum(int(row["points"]) for row in self.table(file, OBSTACLES_HEADER))
                  for file in ("obstacles.csv", "far.csv")]
        self.assertGreater(points[0], points[1])
        kinds = [row["kind"] for row in self.table("obstacles.csv", OBSTACLES_HEADER)]
        self.assertIn("box", kinds)
        self.assertLessEqual(set(kinds), {"line", "circle", "box", "unknown"})
        classes = [row["kind"] for row in self.table("outliers.csv", OUTLIERS_HEADER)]
        self.assertGreater(classes.count("obstacle"), 0.95 * len(classes))

    def test_what_came_is_proposed_for_the_map_and_nothing_is_edited(self):
        # Slower than the other runs: what is gone within three seconds is not proposed.
        self.done("simulate", "--out", "slow.clf", "--obstacle", "A1", "--speed", "0.6")
        words = ("localize", "slow.clf", "--map", "map.csv", "--initial-pose", self.pose, "--proposals", "changes.json")
        before = self.read("map.csv")
        self.assertEqual(self.summary(*words)["proposals"], 1)
        proposals = json.loads(self.read("changes.json"))["proposals"]
        self.assertEqual([proposal["kind"] for proposal in proposals], ["add"])
        proposal = proposals[0]
        self.assertLess(math.hypot(proposal["x"] - 9.0, proposal["y"] - 0.3), 0.2)
        self.assertGreaterEqual(proposal["evidence"]["scans"], 8)
        self.assertGreaterEqual(proposal["evidence"]["share"], 0.8)
        self.assertGreater(len(proposal["points"]), 5)
        self.assertIn("to add", self.read("changes.svg"))
        self.assertEqual(self.read("map.csv"), before)
        self.could_not(*words, "--update-map", "new.pcd", says=("--proposals", "--update-map"))

    def test_outliers_are_those_of_brute_force_at_the_pose_that_was_written(self):
        points = self.numbers("map.csv")[::12]  # thin, so that looking at all pairs takes a second
        self.write("thin.csv", "".join(f"{x:.17g},{y:.17g}\n" for x, y in points))
        self.done("localize", "run.clf", "--map", "thin.csv", "--initial-pose", self.pose, "--trajectory", "run.tum",
                  "--outliers", "outliers.csv", "--outlier-distance", "0.1")
        self.done("convert", "run.clf", "ranges.csv")
        poses, ranges = self.trajectory("run.tum"), self.numbers("ranges.csv")
        found = {(int(row["scan"]), int(row["beam"])): row for row in self.table("outliers.csv", OUTLIERS_HEADER)}
        checked = 0
        for scan in (0, len(poses) // 3, len(poses) // 2):
            for beam, reading in enumerate(ranges[scan]):
                if reading == 0.0:
                    self.assertNotIn((scan, beam), found)
                    continue
                angle = math.radians(-135.0 + 0.25 * beam)
                x, y = moved(poses[scan][1:], (reading * math.cos(angle), reading * math.sin(angle)))
                distance = min(math.hypot(x - px, y - py) for px, py in points)
                if abs(distance - 0.1) < 1e-4 or abs(distance - 0.3) < 1e-4:
                    continue  # too near the limit to tell from rounded files
                self.assertEqual((scan, beam) in found, distance > 0.1, (scan, beam, distance))
                if distance > 0.1:
                    row = found[scan, beam]
                    self.assertLess(math.hypot(float(row["x"]) - x, float(row["y"]) - y), 1e-4)
                    written = float(row["distance"])
                    self.assertAlmostEqual(written, distance if distance < 0.3 else math.inf, delta=1e-4)
                    checked += 1
        self.assertGreater(checked, 10)

    def test_without_a_pose_it_warns_and_starts_at_the_origin(self):
        result = self.done("localize", "run.clf", "--map", "map.csv", "--trajectory", "run.tum")
        self.assertIn("--initial-pose", result.stderr)
        self.assertEqual(len(self.trajectory("run.tum")), self.start["scans"], "a line for lost scans too")

    def test_thread_counts_give_the_same_bytes(self):
        for threads in (1, 3):
            self.done("localize", "run.clf", "--map", "map.csv", "--initial-pose", self.pose, "--threads", threads,
                      "--trajectory", f"{threads}.tum")
        self.assertEqual(self.read("1.tum"), self.read("3.tum"))


class Map(CommandTest):
    def test_map_trajectory_and_pictures(self):
        run = self.summary("simulate", "--out", "run.clf", "--truth", "truth.tum", "--speed", "2")
        told = self.summary("map", "run.clf", "--out", "map.ply", "--trajectory", "run.tum", "--picture", "map.svg")
        self.assertEqual(told["scans"], run["scans"])
        self.assertEqual(told["unmatched_scans"], 0)
        self.assertEqual(len(self.trajectory("run.tum")), run["scans"])
        info = self.summary("info", "map.ply")
        self.assertEqual((info["kind"], info["dimension"], info["points"]), ("cloud", 2, told["map_points"]))
        self.assertTrue(self.read("map.svg").rstrip().endswith("</svg>"))
        error = self.summary("evaluate", "run.tum", "--truth", "truth.tum", "--align", "first")["absolute"]
        self.assertLess(error["translation"]["mean"], 0.05)
        thick = self.summary("map", "run.clf", "--out", "thick.csv", "--all-points")
        self.assertGreater(thick["map_points"], 2 * told["map_points"])


class Interrupted(CommandTest):
    """Ctrl-C leaves nothing half written, and what was there before."""

    def setUp(self):
        super().setUp()
        self.start = self.summary("simulate", "--out", "run.clf", "--map-out", "map.csv", "--speed", "0.2", "--route",
                                  "survey")
        self.before = sorted(os.listdir(self.folder))

    def interrupt(self, words, ready, by=signal.SIGINT):
        process = subprocess.Popen([PROGRAM, *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for _ in range(2000):
            if ready() or process.poll() is not None:
                break
            time.sleep(0.005)
        self.assertIsNone(process.poll(), "it was done before it could be interrupted")
        process.send_signal(by)
        output, _ = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 128 + by)
        self.assertEqual(output, b"")
        self.assertEqual(sorted(os.listdir(self.folder)), self.before)

    def test_in_a_long_map(self):
        began = time.monotonic()
        self.interrupt(["map", "run.clf", "--out", "out.csv", "--trajectory", "out.tum", "--all-points", "--json", "-"],
                       ready=lambda: time.monotonic() - began > 1.0)

    def test_while_tables_are_being_written(self):
        self.write("metrics.csv", "what was there before\n")
        self.before = sorted(os.listdir(self.folder))
        words = ["localize", "run.clf", "--map", "map.csv", "--initial-pose", pose_words(self.start["initial_pose"]),
                 "--metrics", "metrics.csv", "--outliers", "outliers.csv", "--trajectory", "run.tum"]
        self.interrupt(words, ready=lambda: len(os.listdir(self.folder)) == len(self.before) + 2, by=signal.SIGTERM)
        self.assertEqual(self.read("metrics.csv"), "what was there before\n")


if __name__ == "__main__":
    unittest.main()
