# SPDX-License-Identifier: Apache-2.0
"""The report of slamicp localize: what it tells of how sure the localizer was."""
import re
import unittest

from command import METRICS_HEADER, CommandTest, pose_words

CORRIDOR = """
world: long corridor
walls:
  - rectangle: {centre: [50, 0], width: 100, depth: 2.4, heading_deg: 0}
routes:
  - {name: there, waypoints: [[30, 0], [45, 0], [60, 0]]}
"""


class Report(CommandTest):
    def simulated(self, *words):
        return self.summary("simulate", "--out", "run.clf", "--map-out", "map.csv", "--speed", "1.5", *words)

    def localize(self, *words):
        """States of the metrics, states of the report's table, the report."""
        self.done("localize", "run.clf", "--map", "map.csv", "--metrics", "metrics.csv", "--report", "report.html", *words)
        states = [row["state"] for row in self.table("metrics.csv", METRICS_HEADER)]
        page = self.read("report.html")
        rows = re.findall(r"<tr><td>(\w+)</td><td>(\d+)</td><td>([\d.]+) %</td><td>([\d.]+) s</td></tr>", page)
        self.assertEqual([row[0] for row in rows], ["tracking", "degenerate", "suspect", "lost"])
        for state, count, share, longest in rows:
            self.assertEqual(int(count), states.count(state), state)
            self.assertAlmostEqual(float(share), 100.0 * states.count(state) / len(states), delta=0.06)
            if state not in states:
                self.assertEqual(float(longest), 0.0, state)
        for state in set(states):
            self.assertIn(f">path, {state} ({states.count(state)})<", page)
        for word in ("probability that the pose is right", "standard deviations", "heading [mrad]", "time [s]"):
            self.assertIn(f">{word}<", page)
        self.assertNotIn("nan", re.sub(r"[a-z]*nan[a-z]+", "", page))
        return states, page

    def test_a_good_run_tracks_and_has_ellipses(self):
        start = self.simulated()["initial_pose"]
        states, page = self.localize("--initial-pose", pose_words(start))
        self.assertEqual(set(states), {"tracking"})
        self.assertRegex(page, r">95 % ellipses, x \d+<")
        for word in ("path, suspect", "path, lost", "blind direction"):
            self.assertNotIn(f">{word}", page)

    def test_a_blind_corridor_shows_which_direction(self):
        self.write("corridor.yaml", CORRIDOR)
        self.simulated("--world", "corridor.yaml")
        states, page = self.localize("--initial-pose", "30,0,0")
        self.assertGreater(states.count("degenerate"), 100)
        self.assertIn(">blind direction<", page)
        # The path is a small part of its map: it is shown once more, larger.
        self.assertEqual(page.count(">blind direction<"), 2)

    def test_a_robot_put_down_elsewhere_is_drawn_as_lost(self):
        start = self.simulated()["initial_pose"]
        states, page = self.localize("--initial-pose", f"{start['x'] + 3.0},{start['y']},{start['theta'] + 1.5}")
        self.assertIn("lost", states)
        # Its band lies behind both charts, 35 % opaque.
        self.assertEqual(len(re.findall(r'fill="#141418" fill-opacity="0.35"', page)), 2 * self.stretches(states, "lost"))

    @staticmethod
    def stretches(states, state):
        return sum(now == state and before != state for before, now in zip([None] + states, states))


if __name__ == "__main__":
    unittest.main()
