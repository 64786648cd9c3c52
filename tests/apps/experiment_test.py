# SPDX-License-Identifier: Apache-2.0
"""slamicp experiment: the paper's experiments, reduced: one run, few obstacles, few speeds."""
import csv
import re
import unittest
import xml.etree.ElementTree

from command import CommandTest


class Experiment(CommandTest):
    def experiment(self, name, folder, *words):
        return self.summary("experiment", name, "--out", folder, "--no-times", *words)

    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def check_files(self, folder, name, pictures):
        """Table, page and pictures are whole and stand by themselves."""
        self.assertTrue(self.rows(f"{folder}/{name}.csv"))
        page = self.read(f"{folder}/{name}.html")
        self.assertTrue(page.startswith("<!DOCTYPE html>"))
        self.assertIn("Simulated: ", page)
        self.assertEqual(re.findall(r'(?:src|href)="', page), [], "the page needs other files")
        self.assertEqual(page.count("<svg"), len(pictures))
        for picture in pictures:
            xml.etree.ElementTree.parse(self.folder / folder / f"{picture}.svg")
            self.assertEqual((self.folder / folder / f"{picture}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def assert_same_bytes(self, one, other):
        names = sorted(path.name for path in (self.folder / one).iterdir())
        self.assertEqual(names, sorted(path.name for path in (self.folder / other).iterdir()))
        for name in names:
            self.assertEqual((self.folder / one / name).read_bytes(), (self.folder / other / name).read_bytes(), name)

    def test_table1_finds_every_obstacle_and_both_agents_agree(self):
        words = ("--obstacles", "A1", "--runs", "1", "--every", "400")
        told = self.experiment("table1", "one", *words)
        self.check_files("one", "table1", ["table1"])
        self.assertAlmostEqual(told["map_points"], 10402, delta=1040)
        self.assertEqual([row["obstacle"] for row in told["rows"]], ["none", "A1"])
        for row in told["rows"]:
            self.assertTrue(row["found"])
            self.assertEqual(row["runs_finished"], 1)
            self.assertEqual(row["cycles_held_back"], 0)
            self.assertAlmostEqual(row["outliers_mean_original"], row["outliers_mean_improved"], delta=2.0)
        none, a1 = (row["most_outliers"] for row in told["rows"])
        self.assertLessEqual(none, 10)
        self.assertAlmostEqual(a1, 82, delta=20)
        self.assertFalse(list((self.folder / "one").glob("*times*")))
        self.experiment("table1", "other", *words)
        self.assert_same_bytes("one", "other")

    def test_table1_tells_times_where_they_are_wanted(self):
        told = self.summary("experiment", "table1", "--out", "t", "--obstacles", "B1", "--runs", "1", "--every", "600")
        row = self.rows("t/table1_times.csv")[1]
        self.assertEqual(row["obstacle"], "B1")
        self.assertAlmostEqual(float(row["paper_improvement_percent"]), 36.78, delta=0.01)
        for name in ("original_ms", "improved_ms", "original_rebuilt_ms", "improved_rebuilt_ms"):
            self.assertGreater(float(row[name]), 0.0)
        self.assertGreater(told["mean_improvement_percent"], 50.0)
        self.assertIn("Times, on the machine", self.read("t/table1.html"))
        self.assertTrue((self.folder / "t" / "table1_times.png").is_file())

    def test_velocity_makes_no_difference(self):
        told = self.experiment("velocity", "v", "--obstacles", "B2", "--runs", "2", "--speeds", "0.45,0.55")
        self.check_files("v", "velocity", ["velocity_B2_outliers", "velocity_B2_inlier_distance"])
        none, b2 = told["series"]
        self.assertLess(b2["outliers_between_speeds"], b2["outliers_run_to_run"])
        self.assertLess(none["inlier_distance_between_speeds"], none["inlier_distance_run_to_run"])
        self.assertLess(abs(b2["change_percent"]), 5.0)
        speeds = {row["speed_m_per_s"] for row in self.rows("v/velocity.csv")}
        self.assertEqual(speeds, {"0.450", "0.550"})

    def test_snapshots_show_the_obstacle_from_three_places(self):
        told = self.experiment("snapshots", "s", "--obstacles", "B2")
        self.check_files("s", "snapshots", [f"snapshot_B2_{label}" for label in "abc"])
        outliers = [view["outliers"] for view in told["views"]]
        self.assertEqual([view["label"] for view in told["views"]], ["a", "b", "c"])
        self.assertGreaterEqual(min(outliers), 4)
        self.assertGreater(outliers[1], outliers[0])
        self.assertLessEqual(max(outliers), 40)

    def test_maps_have_the_papers_point_counts(self):
        told = self.experiment("maps", "m")
        figures = ["2a", "2b", "3a", "3b", "4", "5A", "5B", "5C", "5D", "6a", "6b", "7a", "7b", "8a", "8b"]
        self.check_files("m", "maps", [f"figure_{name}" for name in figures])
        pair = told["pairs"][1]
        self.assertEqual((pair["M"], pair["T"], pair["updated_all_points"]), (1081, 1081, 2162))
        self.assertAlmostEqual(pair["updated_outliers_only"], 1617, delta=150)
        self.assertLess(pair["error_mm"], 5.0)

    def test_reconstruction_measures_the_obstacle(self):
        told = self.experiment("reconstruction", "r", "--obstacles", "B2")
        self.check_files("r", "reconstruction", ["reconstruction_B2_30cm", "reconstruction_B2_10cm"])
        for thing in told["things"]:
            self.assertAlmostEqual(thing["radius"], 0.042, delta=0.015)
            self.assertAlmostEqual(thing["width"], 0.084, delta=0.03)

    def test_wrong_words(self):
        self.wrong_words("experiment", "nonsense", "--out", "x")
        self.wrong_words("experiment", "maps")
        self.wrong_words("experiment", "velocity", "--out", "x", "--speeds", "-1")
        self.could_not("experiment", "table1", "--out", "x", "--obstacles", "E1", says=("E1", "A1 to D3"))

    def test_crowd_fewer_surroundings_are_known_the_more_people_there_are(self):
        told = self.experiment("crowd", "crowd", "--people", "0,20")
        layouts = ["crossing", "along", "groups", "random_walk"]
        self.check_files("crowd", "crowd", [f"crowd_{layout}_{what}" for layout in layouts
                                            for what in ("outliers", "awareness")])
        self.assertEqual([drive["layout"] for drive in told["drives"][::2]], layouts)
        for none, many in zip(told["drives"][::2], told["drives"][1::2]):
            self.assertEqual((none["people"], many["people"]), (0, 20))
            self.assertLess(none["outliers"], 5)
            self.assertGreater(many["outliers"], 100)
            self.assertGreater(none["awareness"], 0.98)
            self.assertLess(many["awareness"], 0.9)
            self.assertLess(many["error_mean"], none["error_mean"] + 0.005)
            self.assertEqual(none["false_stops"], 0)
            self.assertEqual(none["stopped"], 0)
        self.assertGreater(told["correlation_people_outliers"], 0.9)
        self.assertLess(told["correlation_outliers_awareness"], -0.7)
        self.assertEqual(len({(row["layout"], row["people"]) for row in self.rows("crowd/crowd.csv")}), 8)


if __name__ == "__main__":
    unittest.main()
