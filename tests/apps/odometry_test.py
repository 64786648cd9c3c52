# SPDX-License-Identifier: Apache-2.0
"""slamicp odometry, and what localize tells of the wheels, on the simulated corridor."""
import unittest

from command import CommandTest


class Odometry(CommandTest):
    def setUp(self):
        super().setUp()
        self.told = self.summary("simulate", "--out", "run.clf", "--speed", "0.55", "--truth", "truth.tum", "--map-out",
                                 "map.pcd")

    def test_the_laser_alone_follows_the_robot(self):
        told = self.summary("odometry", "run.clf", "--trajectory", "odometry.tum", "--picture", "odometry.svg")
        self.assertEqual((told["scans"], told["unmatched_scans"]), (self.told["scans"], 0))
        self.assertEqual(len(self.trajectory("odometry.tum")), told["scans"])
        self.assertIn("<svg", (self.folder / "odometry.svg").read_text()[:200])
        error = self.summary("evaluate", "odometry.tum", "--truth", "truth.tum", "--align", "first")
        self.assertLess(error["absolute"]["translation"]["max"], 0.1)
        self.assertAlmostEqual(error["relative"]["distance"], 1.0)
        self.assertLess(error["relative"]["translation_per_metre"], 0.01)
        self.assertGreater(error["relative"]["translation"]["count"], 100)

    def test_scan_to_scan_drifts_more(self):
        worst = {}
        for reference in ("local-map", "previous-scan"):
            self.summary("odometry", "run.clf", "--reference", reference, "--trajectory", "odometry.tum")
            error = self.summary("evaluate", "odometry.tum", "--truth", "truth.tum", "--align", "first",
                                 "--relative-distance", "5")
            worst[reference] = error["relative"]["translation"]["mean"]
        self.assertLess(worst["local-map"], worst["previous-scan"])

    def test_a_path_shorter_than_the_stretch_has_no_relative_error(self):
        told = self.summary("evaluate", "truth.tum", "--truth", "truth.tum", "--relative-distance", "1000")
        self.assertNotIn("relative", told)
        self.assertEqual(told["absolute"]["translation"]["max"], 0.0)

    def test_localize_tells_what_the_wheels_get_wrong(self):
        start = self.told["initial_pose"]
        told = self.summary("localize", "run.clf", "--map", "map.pcd", "--initial-pose",
                            f"{start['x']},{start['y']},{start['theta']}", "--calibrate-odometry")
        found = told["odometry_calibration"]
        self.assertTrue(found["determined"])
        # The simulator's wheels count one percent too much of both, and veer.
        self.assertLess(abs(found["translation"]["value"] - 1 / 1.01), 4 * found["translation"]["sigma"] + 0.003)
        self.assertLess(abs(found["drift_per_metre"]["value"] + 0.003), 4 * found["drift_per_metre"]["sigma"] + 0.002)
        self.assertLess(found["rms_after"], found["rms_before"])

    def test_wrong_words(self):
        self.wrong_words("odometry")
        self.wrong_words("odometry", "run.clf", "--reference", "nothing")
        self.wrong_words("odometry", "run.clf", "--map-radius", "0")
        self.could_not("odometry", "missing.clf")


if __name__ == "__main__":
    unittest.main()
