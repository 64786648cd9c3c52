# SPDX-License-Identifier: Apache-2.0
"""slamicp simulate in worlds of files: routes, people, doors, floor plans, lidars, robots; slamicp info of a world."""
import pathlib
import unittest

from command import CommandTest, pose_words

WORLDS = pathlib.Path(__file__).resolve().parents[2] / "examples" / "worlds"
OFFICE = WORLDS / "office.yaml"
HALL = WORLDS / "hall.yaml"

ROOM = """world: room
walls:
  - rectangle: {centre: [3, 2], width: 6, depth: 4}
doors:
  - {name: closet, hinge: [6, 1], latch: [6, 2], open_deg: 0, mapped_open_deg: 90}
obstacles:
  - {name: box, boxes: [{centre: [4.5, 3.4], width: 0.4, depth: 0.3}]}
people:
  - {name: Ada, way: [[4, 0.5], [4, 3]]}
routes:
  - {name: there, waypoints: [[1, 1], [2, 1.2], [3, 1]]}
  - {name: back, waypoints: [[3, 1], [2, 1.2], [1, 1]]}
"""


class Worlds(CommandTest):
    def simulate(self, world, *words, prefix="run"):
        return self.summary("simulate", "--world", world, "--out", prefix + ".clf", "--truth", prefix + ".tum",
                            "--map-out", prefix + ".csv", "--speed", "1", *words)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def test_a_world_of_a_file_is_driven_and_localized_in(self):
        told = self.simulate(OFFICE, "--lidar", "real-hokuyo")
        self.assertEqual((told["route"], told["people"], told["lidar"]), ("patrol", 3, "real-hokuyo"))
        found = self.summary("localize", "run.clf", "--map", "run.csv", "--initial-pose",
                             pose_words(told["initial_pose"]), "--trajectory", "found.tum", "--outlier-distance", "0.1",
                             "--max-correspondence-distance", "0.3")
        self.assertNotIn("no_overlap", found["stops"])
        self.assertGreater(found["outliers_max"], 50)
        errors = self.summary("evaluate", "found.tum", "--truth", "run.tum")["absolute"]
        self.assertLess(errors["translation"]["mean"], 0.05)

    def test_the_first_route_is_the_default_and_others_go_by_name(self):
        self.write("room.yaml", ROOM)
        first = self.simulate("room.yaml")
        self.assertEqual(first["route"], "there")
        self.assertAlmostEqual(first["initial_pose"]["x"], 1.0)
        self.assertAlmostEqual(self.simulate("room.yaml", "--route", "back")["initial_pose"]["x"], 3.0)
        self.could_not("simulate", "--out", "no.clf", "--world", "room.yaml", "--route", "nowhere",
                       says=("no route 'nowhere'", "there, back"))

    def test_the_map_holds_what_stood_there_when_it_was_made(self):
        self.write("room.yaml", ROOM)
        self.simulate("room.yaml")
        points = self.numbers("run.csv")
        near = lambda x, y, within: sum(abs(px - x) < within and abs(py - y) < within for px, py in points)
        self.assertEqual(near(6.0, 1.5, 0.3), 0, "the closed door")
        self.assertGreater(near(5.5, 1.0, 0.2), 50, "the same as it stood open")
        self.assertEqual(near(4.5, 3.4, 0.3), 0, "the box")

    def test_people_come_by_seed(self):
        self.write("room.yaml", ROOM)
        alone = self.simulate("room.yaml")
        self.assertEqual(alone["people"], 1)
        for layout in ("crossing", "along", "groups", "random-walk"):
            with self.subTest(layout=layout):
                words = ("--people", "3", "--layout", layout, "--route", "patrol")
                told = self.simulate(OFFICE, *words, "--seed", "5", prefix="a")
                self.simulate(OFFICE, *words, "--seed", "5", prefix="b")
                self.simulate(OFFICE, *words, "--seed", "6", prefix="c")
                self.assertEqual(told["people"], 6)
                self.assertEqual(self.bytes_of("a.clf"), self.bytes_of("b.clf"))
                self.assertEqual(self.bytes_of("a.csv"), self.bytes_of("b.csv"))
                self.assertNotEqual(self.bytes_of("a.clf"), self.bytes_of("c.clf"))
        # The way and the map are the same with and without people.
        self.simulate("corridor", prefix="empty")
        self.simulate("corridor", "--people", "5", prefix="full")
        self.assertEqual(self.bytes_of("empty.tum"), self.bytes_of("full.tum"))
        self.assertEqual(self.bytes_of("empty.csv"), self.bytes_of("full.csv"))
        self.assertNotEqual(self.bytes_of("empty.clf"), self.bytes_of("full.clf"))

    def test_a_robot_on_three_wheels_gets_there_too(self):
        self.write("room.yaml", ROOM)
        told = self.simulate("room.yaml", "--robot", "omni")
        self.assertEqual(told["robot"], "omni")
        end = self.trajectory("run.tum")[-1]
        self.assertAlmostEqual(end[1], 3.0, delta=0.05)
        self.assertAlmostEqual(end[2], 1.0, delta=0.05)

    def test_lidars_differ_in_noise(self):
        self.write("room.yaml", ROOM)
        for name in ("hokuyo", "exact-hokuyo", "real-hokuyo"):
            self.simulate("room.yaml", "--lidar", name, prefix=name)
        self.assertEqual(self.bytes_of("hokuyo.tum"), self.bytes_of("real-hokuyo.tum"))
        logs = {self.bytes_of(name + ".clf") for name in ("hokuyo", "exact-hokuyo", "real-hokuyo")}
        self.assertEqual(len(logs), 3)

    def test_who_localizes_in_the_floor_plan_finds_the_walls_where_the_simulator_has_them(self):
        told = self.simulate(HALL, "--route", "aisle")
        found = self.summary("localize", "run.clf", "--map", WORLDS / "hall_map.yaml", "--initial-pose",
                             pose_words(told["initial_pose"]), "--trajectory", "found.tum")
        self.assertNotIn("no_overlap", found["stops"])
        errors = self.summary("evaluate", "found.tum", "--truth", "run.tum")["absolute"]
        self.assertLess(errors["translation"]["mean"], 0.03)

    def test_info_tells_what_a_world_holds(self):
        told = self.summary("info", OFFICE)
        self.assertEqual((told["kind"], told["world"]), ("world", "office"))
        self.assertEqual(len(told["doors"]), 5)
        self.assertEqual({door["name"] for door in told["doors"] if door["open_deg"] != door["mapped_open_deg"]},
                         {"lab", "store"})
        self.assertEqual((told["people"], told["people_walking"], told["obstacles"]), (3, 2, 2))
        self.assertEqual([route["name"] for route in told["routes"]], ["patrol", "survey", "kitchen"])
        for axis, size in enumerate((18.0, 10.0)):
            self.assertAlmostEqual(told["lower"][axis], 0.0)
            self.assertAlmostEqual(told["upper"][axis], size)
        text = self.done("info", OFFICE).stdout
        self.assertIn("lab, 0.90 m wide, open 100 deg, in the map closed", text)
        self.assertIn("store, 0.90 m wide, closed, in the map open 90 deg", text)
        self.assertEqual(self.summary("info", HALL)["kind"], "world")
        self.assertEqual(self.summary("info", WORLDS / "hall_map.yaml")["kind"], "map")

    def test_a_picture_shows_the_world(self):
        self.write("room.yaml", ROOM)
        self.simulate("room.yaml", "--picture", "room.svg")
        picture = self.read("room.svg")
        for words in ("walls", "doors as the map has them", "what the map does not know", "people"):
            self.assertIn(words, picture)

    def test_mistakes_are_told_with_their_line_and_leave_nothing(self):
        for text, says in ((ROOM.replace("hinge", "hinges"), ("room.yaml:5", "'hinges'", "did you mean 'hinge'?")),
                           (ROOM.replace("width: 6", "width: -6"), ("room.yaml:3", "'width'", "-6")),
                           (ROOM.replace("[4, 0.5]", "[4, nan]"), ("room.yaml:9", "'way'", "nan")),
                           (ROOM[:ROOM.index("routes")], ("no routes", "give it one")),
                           ("image: a.pgm\n", ("room.yaml", "no world")),
                           ("world: [\n", ("room.yaml:", "no YAML"))):
            with self.subTest(says=says):
                self.write("room.yaml", text)
                self.could_not("simulate", "--world", "room.yaml", "--out", "run.clf", "--map-out", "map.csv", says=says)
                self.assertEqual([path.name for path in self.folder.iterdir()], ["room.yaml"])
        self.could_not("simulate", "--world", "none.yaml", "--out", "run.clf", says=("none.yaml", "cannot be read"))
        self.write("room.yaml", ROOM)
        self.could_not("simulate", "--world", "room.yaml", "--out", "run.clf", "--obstacle", "A1",
                       says=("--obstacle", "corridor"))
        self.could_not("localize", "none.clf", "--map", "room.yaml", says=())
        self.could_not("convert", "room.yaml", "map.csv", says=("is a world", "--map-out"))
        self.wrong_words("simulate", "--out", "run.clf", "--people", "-1")
        self.wrong_words("simulate", "--out", "run.clf", "--lidar", "sonar")
        self.wrong_words("simulate", "--out", "run.clf", "--robot", "walker")
        self.wrong_words("simulate", "--out", "run.clf", "--layout", "queue")


if __name__ == "__main__":
    unittest.main()
