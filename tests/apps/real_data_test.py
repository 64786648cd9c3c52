# SPDX-License-Identifier: Apache-2.0
"""The command on real logs and clouds."""
import math
import unittest

from command import METRICS_HEADER, CommandTest, data_dir

DATA = data_dir()


class RealData(CommandTest):
    def setUp(self):
        if DATA is None:
            self.skipTest("no data")
        super().setUp()

    def test_info_reads_every_log_and_cloud(self):
        for path, kind, holds in (("slam_benchmark/intel.clf", "log", 13631), ("slam_benchmark/fr079.clf", "log", 4934),
                                  ("hokuyo/flying-rsise_utm30lx.csv", "log", 190),
                                  ("hokuyo/birmingham_trace0.bag", "log", 958),
                                  ("hokuyo/birmingham_trace1.bag", "log", 906),
                                  ("hokuyo/scan_tools_demo.bag", "log", 360),
                                  ("obstacles/leg_positive_1_extracted.bag", "log", 197),
                                  ("corridor/ranges_none.csv", "log", 300), ("corridor/ranges_box.csv", "log", 300),
                                  ("corridor/map.csv", "cloud", 10402), ("registration/bun0.pcd", "cloud", 397),
                                  ("registration/bun4.pcd", "cloud", 361),
                                  ("registration/lpm_2D_oneBox.csv", "cloud", 361),
                                  ("registration/lpm_2D_twoBoxes.csv", "cloud", 361),
                                  ("registration/small_gicp_source.ply", "cloud", 69792),
                                  ("registration/small_gicp_target.ply", "cloud", 69088)):
            with self.subTest(path=path):
                if not (DATA / path).exists():
                    self.skipTest(f"no {path}")
                told = self.summary("info", DATA / path)
                self.assertEqual(told["kind"], kind)
                self.assertEqual(told["scans" if kind == "log" else "points"], holds)

    def test_a_bag_of_three_lasers(self):
        bag = DATA / "obstacles/leg_negative_2.bag"
        self.could_not("odometry", bag, says=("/left_scan, /rear_scan, /right_scan", "--scan-topic"))
        told = self.summary("info", bag)
        self.assertEqual([(laser["name"], laser["scans"]) for laser in told["lasers"]],
                         [("/left_scan", 435), ("/rear_scan", 435), ("/right_scan", 434)])

    def test_a_bag_becomes_carmen(self):
        self.done("convert", DATA / "hokuyo/birmingham_trace0.bag", "run.clf")
        bag, carmen = self.summary("info", DATA / "hokuyo/birmingham_trace0.bag"), self.summary("info", "run.clf")
        for fact in ("scans", "beams", "scans_with_odometry"):
            self.assertEqual(carmen[fact], bag[fact])
        for fact in ("odometry_path", "duration", "return_share", "angle_min"):
            self.assertAlmostEqual(carmen[fact], bag[fact], places=4)
        self.assertAlmostEqual(carmen["laser_offset"]["x"], bag["laser_offset"]["x"], places=4)

    def test_birmingham_is_localized_in_the_map_of_another_run(self):
        hokuyo = DATA / "hokuyo"
        self.summary("map", hokuyo / "birmingham_trace0.bag", "--out", "trace0.pcd")
        self.summary("map", hokuyo / "birmingham_trace1.bag", "--out", "trace1.pcd", "--trajectory", "mapped.tum")
        # The robot goes on where trace0 had not been, so the map grows on the way.
        told = self.summary("localize", hokuyo / "birmingham_trace1.bag", "--map", "trace0.pcd", "--initial-pose",
                            "-0.4,0,-0.06", "--outlier-distance", "0.05", "--update-map", "grown.pcd", "--trajectory",
                            "found.tum", "--metrics", "found.csv")
        self.assertEqual(told["scans"], 906)
        rows = self.table("found.csv", METRICS_HEADER)
        good = [row for row in rows if row["stop"] == "converged" and 2 * int(row["inliers"]) >= int(row["points"])]
        self.assertGreaterEqual(len(good), 0.99 * 906)
        apart = self.summary("evaluate", "found.tum", "--truth", "mapped.tum", "--align", "se2")["absolute"]
        self.assertLess(apart["translation"]["max"], 0.3)
        self.assertLess(math.degrees(apart["rotation"]["max"]), 5.0)

    def test_odometry_without_wheels_runs_through(self):
        for bag, words, scans in (("hokuyo/scan_tools_demo.bag", (), 360),
                                  ("obstacles/leg_negative_2.bag", ("--scan-topic", "left_scan"), 435)):
            told = self.summary("odometry", DATA / bag, *words)
            self.assertEqual((told["scans"], told["unmatched_scans"]), (scans, 0))
            self.assertLess(told["end_to_start"]["translation"], 0.6)

    def test_fr079_is_mapped_and_found_again_in_its_map(self):
        scans = 0
        with open(DATA / "slam_benchmark/fr079.clf") as log, open(self.folder / "run.clf", "w") as some:
            for line in log:
                some.write(line)
                scans += line.startswith("FLASER")
                if scans == 600:
                    break
        told = self.summary("map", "run.clf", "--out", "map.pcd", "--trajectory", "mapped.tum")
        self.assertEqual((told["scans"], told["unmatched_scans"]), (600, 0))
        told = self.summary("localize", "run.clf", "--map", "map.pcd", "--initial-pose", "0,0,0", "--trajectory",
                            "found.tum")
        self.assertEqual(len(self.trajectory("found.tum")), 600)
        self.assertNotIn("no_overlap", told["stops"])
        apart = self.summary("evaluate", "found.tum", "--truth", "mapped.tum")["absolute"]
        self.assertLess(apart["translation"]["mean"], 0.03)
        self.assertLess(apart["translation"]["max"], 0.2)
        score = self.summary("evaluate", "found.tum", "--relations", DATA / "slam_benchmark/fr079.relations")
        self.assertLess(score["all"]["translation"]["mean"], 0.06)

    def test_a_drive_is_found_in_the_map_server_map_of_its_building(self):
        folder = DATA / "maps_localization"
        log, floor = folder / "macfirst_floor_take_2_0.db3", folder / "mac_1st_floor_final.yaml"
        if not log.exists() or not floor.exists():
            self.skipTest("no mac_1st_floor")
        result = self.run_command("info", log)
        if result.returncode != 0 and "build" in result.stderr:
            self.skipTest(result.stderr)
        # Found by trying poses all over the map; the robot turns and drives 8 m.
        told = self.summary("localize", log, "--map", floor, "--initial-pose", "6.859,-8.351,1.773")
        self.assertEqual((told["scans"], told["stops"].get("no_overlap", 0)), (357, 0))
        self.assertGreater(told["inliers_mean"], 480)
        self.assertLess(told["mean_inlier_distance"], 0.035)
        last = told["last_pose"]
        for axis, value, tolerance in (("x", 9.025, 0.05), ("y", -13.997, 0.05), ("theta", -0.937, 0.03)):
            self.assertAlmostEqual(last[axis], value, delta=tolerance)


if __name__ == "__main__":
    unittest.main()
