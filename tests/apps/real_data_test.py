# SPDX-License-Identifier: Apache-2.0
"""The command on real logs and clouds."""
import unittest

from command import CommandTest, data_dir

DATA = data_dir()


class RealData(CommandTest):
    def setUp(self):
        if DATA is None:
            self.skipTest("no data")
        super().setUp()

    def test_info_reads_every_log_and_cloud(self):
        for path, kind, holds in (("slam_benchmark/intel.clf", "log", 13631), ("slam_benchmark/fr079.clf", "log", 4934),
                                  ("hokuyo/flying-rsise_utm30lx.csv", "log", 190),
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


if __name__ == "__main__":
    unittest.main()
