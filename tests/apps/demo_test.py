# SPDX-License-Identifier: Apache-2.0
"""slamicp demo: the first thing a newcomer runs."""
import os
import unittest

from command import CommandTest


class Demo(CommandTest):
    def test_maps_localizes_and_finds_the_obstacle(self):
        told = self.summary("demo", "--out", "demo")
        self.assertLess(abs(told["map_points"] - 10000), 3000)
        self.assertLess(told["translation_error"]["mean"], 0.02)
        self.assertEqual(len(told["obstacles"]), 1)
        found, standing = told["obstacles"][0], told["true_obstacle"]
        for name in ("x", "y", "width", "depth"):
            self.assertAlmostEqual(found[name], standing[name], delta=0.05)
        files = sorted(os.listdir(self.folder / "demo"))
        self.assertEqual([name for name in files if name.startswith(".")], [])
        for name in ("map.svg", "run.svg", "report.html", "map.pcd", "run.tum", "truth.tum"):
            self.assertIn(name, files)
            self.assertGreater((self.folder / "demo" / name).stat().st_size, 1000)
        for name in ("run.svg", "report.html"):
            self.assertIn(">path, tracking (", self.read(f"demo/{name}"))
            self.assertRegex(self.read(f"demo/{name}"), ">95 % ellipses, x [0-9]+<")


if __name__ == "__main__":
    unittest.main()
