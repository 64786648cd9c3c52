# SPDX-License-Identifier: Apache-2.0
"""slamicp evaluate on hand-made files with known answers."""
import math
import unittest

from command import CommandTest


def tum(poses):
    return "".join(f"{t:.6f} {x} {y} 0 0 0 {math.sin(a / 2):.12f} {math.cos(a / 2):.12f}\n" for t, x, y, a in poses)


class Truth(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("truth.tum", tum([(0, 0, 0, 0), (1, 1, 0, 0), (2, 2, 0, 0.5)]))

    def test_absolute_errors(self):
        self.write("run.tum", tum([(0, 0, 0, 0), (1, 1.03, 0.04, 0), (2, 2, 0.1, 0.6)]))
        told = self.summary("evaluate", "run.tum", "--truth", "truth.tum")["absolute"]
        self.assertEqual((told["translation"]["count"], told["unmatched"]), (3, 0))
        self.assertAlmostEqual(told["translation"]["mean"], 0.05, places=6)
        self.assertAlmostEqual(told["translation"]["rmse"], math.sqrt(0.0125 / 3.0), places=6)
        self.assertAlmostEqual(told["translation"]["max"], 0.1, places=6)
        self.assertAlmostEqual(told["rotation"]["max"], 0.1, places=6)

    def test_alignment_takes_away_where_it_started(self):
        c, s = math.cos(0.3), math.sin(0.3)
        self.write("run.tum", tum([(0, 5, 6, 0.3), (1, 5 + c, 6 + s, 0.3), (2, 5 + 2 * c, 6 + 2 * s, 0.8)]))
        for align, largest in (("first", 1e-6), ("se2", 1e-6)):
            told = self.summary("evaluate", "run.tum", "--truth", "truth.tum", "--align", align)["absolute"]
            self.assertLess(told["translation"]["max"], largest)
        self.assertGreater(self.summary("evaluate", "run.tum", "--truth", "truth.tum")["absolute"]["translation"]["mean"], 5)

    def test_poses_without_a_true_one_are_counted(self):
        self.write("run.tum", tum([(0, 0, 0, 0), (1, 1, 0, 0), (7, 9, 9, 9)]))
        told = self.summary("evaluate", "run.tum", "--truth", "truth.tum")["absolute"]
        self.assertEqual((told["translation"]["count"], told["unmatched"]), (2, 1))
        self.write("elsewhen.tum", tum([(100, 0, 0, 0)]))
        self.could_not("evaluate", "elsewhen.tum", "--truth", "truth.tum")


class Relations(CommandTest):
    def test_the_benchmarks_score(self):
        # The robot turned left by 90 deg at t = 1, then went 1 m: seen from t = 1 it is 1 m ahead.
        self.write("run.tum", tum([(0, 0, 0, 0), (1, 2, 0, math.pi / 2), (100, 2, 1, math.pi / 2)]))
        self.write("some.relations",
                   "0.000000 1.000000 2.0 0.0 0 0 0 1.5707963268\n"      # right
                   "1.000000 100.000000 0.7 0.4 0 0 0 0.1\n"             # 0.3 m ahead and 0.4 m aside: 0.5 m, 0.1 rad
                   "5.000000 6.000000 1 0 0 0 0 0\n")                    # not in the log
        told = self.summary("evaluate", "run.tum", "--relations", "some.relations")
        self.assertEqual((told["all"]["translation"]["count"], told["not_found"]), (2, 1))
        self.assertAlmostEqual(told["all"]["translation"]["mean"], 0.25, places=6)
        self.assertAlmostEqual(told["all"]["translation"]["std"], 0.25, places=6)
        self.assertAlmostEqual(told["all"]["rotation_deg"]["max"], math.degrees(0.1), places=4)
        self.assertEqual(told["over_60_s"]["translation"]["count"], 1)
        self.assertAlmostEqual(told["over_60_s"]["translation"]["mean"], 0.5, places=6)

    def test_no_common_stamp_is_an_error(self):
        self.write("run.tum", tum([(0, 0, 0, 0)]))
        self.write("some.relations", "7 8 1 0 0 0 0 0\n")
        self.could_not("evaluate", "run.tum", "--relations", "some.relations", says=("stamp",))


if __name__ == "__main__":
    unittest.main()
