# SPDX-License-Identifier: Apache-2.0
"""slamicp convert, align and info on clouds."""
import math
import random
import unittest

from command import CommandTest, moved


def csv_text(points):
    return "".join(",".join(f"{value:.17g}" for value in point) + "\n" for point in points)


def room_2d(seed=1):
    """The walls of a room with a pillar, nothing of it symmetric."""
    draw = random.Random(seed)
    corners = [(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (4.0, 2.0), (4.0, 4.5), (0.0, 4.5), (0.0, 0.0)]
    points = []
    for (ax, ay), (bx, by) in zip(corners, corners[1:]):
        for _ in range(int(100 * math.hypot(bx - ax, by - ay))):
            share = draw.random()
            points.append((ax + share * (bx - ax), ay + share * (by - ay)))
    return points


def corner_3d(seed=2):
    """Three walls of a room and a slope in it."""
    draw = random.Random(seed)
    points = []
    for _ in range(2500):
        u, v = 4.0 * draw.random(), 3.0 * draw.random()
        points += [(u, v, 0.0), (u, 0.0, v), (0.0, u, v), (2.0 + 0.4 * u, 1.0 + 0.3 * v, 0.5 * v)]
    return points


def rotation_3d(roll, pitch, yaw):
    cr, sr, cp, sp, cy, sy = (f(a) for a in (roll, pitch, yaw) for f in (math.cos, math.sin))
    return [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr], [-sp, cp * sr, cp * cr]]


class Align(CommandTest):
    def test_2d_writes_T_target_source(self):
        T_target_source = (0.11, -0.07, 0.04)
        x, y, theta = T_target_source
        target = room_2d()
        source = [moved((0.0, 0.0, -theta), (px - x, py - y)) for px, py in target]
        self.write("target.csv", csv_text(target))
        self.write("source.csv", csv_text(source + [(2.0, 2.2), (2.1, 2.2)]))
        for method in ("point-to-line", "point-to-point"):
            with self.subTest(method=method):
                told = self.summary("align", "source.csv", "target.csv", "--method", method, "--transform", "T.txt",
                                    "--outliers", "outliers.csv", "--merged", "merged.csv")
                self.assertEqual((told["dimension"], told["stop"]), (2, "converged"))
                rows = self.numbers("T.txt")
                c, s = math.cos(theta), math.sin(theta)
                for mine, theirs in zip(rows, [[c, -s, x], [s, c, y], [0.0, 0.0, 1.0]]):
                    for a, b in zip(mine, theirs):
                        self.assertAlmostEqual(a, b, delta=1e-3)
                self.assertEqual(rows, [[float(f"{v:.12g}") for v in row] for row in told["T_target_source"]])
                outliers = self.table("outliers.csv", "index,x,y,distance")
                self.assertEqual([int(row["index"]) for row in outliers], [len(source), len(source) + 1])
                self.assertEqual(len(self.numbers("merged.csv")), len(target) + 2)

    def test_3d_writes_T_target_source(self):
        rotation = rotation_3d(0.02, -0.03, 0.05)
        translation = (0.08, -0.05, 0.06)
        source = corner_3d()
        target = [tuple(sum(rotation[r][k] * p[k] for k in range(3)) + translation[r] for r in range(3)) for p in source]
        self.write("target.csv", csv_text(target))
        self.write("source.csv", csv_text(source))
        self.done("convert", "source.csv", "source.ply")
        self.done("convert", "target.csv", "target.pcd")
        # Planes go through the centroids of points some 4 cm apart, and so cut the room's edges a little.
        for method, tolerance in (("point-to-plane", 5e-3), ("point-to-point", 1e-3)):
            with self.subTest(method=method):
                told = self.summary("align", "source.ply", "target.pcd", "--method", method, "--transform", "T.txt",
                                    "--max-iterations", "300")
                self.assertEqual((told["dimension"], told["outliers"]), (3, 0))
                rows = self.numbers("T.txt")
                self.assertEqual(len(rows), 4)
                for r in range(3):
                    self.assertAlmostEqual(rows[r][3], translation[r], delta=tolerance)
                    for c in range(3):
                        self.assertAlmostEqual(rows[r][c], rotation[r][c], delta=tolerance)
                self.assertEqual(rows[3], [0.0, 0.0, 0.0, 1.0])

    def test_an_initial_pose_bridges_what_is_far(self):
        target = room_2d()
        x, y, theta = 3.0, -2.0, 1.2
        source = [moved((0.0, 0.0, -theta), (px - x, py - y)) for px, py in target]
        self.write("target.csv", csv_text(target))
        self.write("source.csv", csv_text(source))
        self.done("align", "source.csv", "target.csv", "--initial-pose", "3.05,-2.05,1.18", "--transform", "T.txt")
        self.assertAlmostEqual(self.numbers("T.txt")[0][2], x, delta=1e-3)
        self.could_not("align", "source.csv", "target.csv", "--initial-pose", "1,2,3,4,5,6", says=("X,Y,THETA",))

    def test_2d_and_3d_do_not_mix(self):
        self.write("flat.csv", csv_text(room_2d()))
        self.write("solid.csv", csv_text(corner_3d()))
        self.could_not("align", "flat.csv", "solid.csv", "--transform", "T.txt", says=("2 and 3 dimensions",))
        self.assertFalse((self.folder / "T.txt").exists())

    def test_no_overlap_is_told_and_the_pose_is_the_guess(self):
        self.write("a.csv", csv_text(room_2d()))
        self.write("b.csv", csv_text([(x + 100.0, y) for x, y in room_2d()]))
        result = self.done("align", "a.csv", "b.csv", "--transform", "T.txt")
        self.assertIn("no_overlap", result.stderr)
        self.assertEqual(self.numbers("T.txt")[0], [1.0, 0.0, 0.0])


class Convert(CommandTest):
    def test_clouds_go_round_without_loss(self):
        for dimension, points in ((2, room_2d()), (3, corner_3d())):
            self.write("a.csv", csv_text(points))
            for flags in ((), ("--ascii",)):
                with self.subTest(dimension=dimension, flags=flags):
                    self.done("convert", "a.csv", "b.pcd", *flags)
                    self.done("convert", "b.pcd", "c.ply", *flags)
                    self.done("convert", "c.ply", "d.xyz", *flags)
                    told = self.summary("convert", "d.xyz", "e.csv")
                    self.assertEqual((told["dimension"], told["points"]), (dimension, len(points)))
                    for mine, theirs in zip(self.numbers("e.csv"), points):
                        for a, b in zip(mine, theirs):
                            self.assertAlmostEqual(a, b, delta=1e-9)
                    info = self.summary("info", "c.ply")
                    self.assertEqual((info["dimension"], info["points"]), (dimension, len(points)))

    def test_logs_go_round(self):
        self.summary("simulate", "--out", "a.clf", "--speed", "20")
        self.done("convert", "a.clf", "b.clf")
        self.assertEqual(self.read("a.clf"), self.read("b.clf"))
        self.done("convert", "a.clf", "a.csv")
        self.done("convert", "a.csv", "c.clf")
        self.done("convert", "c.clf", "c.csv")
        self.assertEqual(self.read("a.csv"), self.read("c.csv"))
        mine, theirs = self.summary("info", "a.clf"), self.summary("info", "c.clf")
        for name in ("scans", "beams", "range_min", "range_max", "return_share", "fov_deg"):
            self.assertEqual(mine[name], theirs[name], name)
        self.assertEqual(theirs["scans_with_odometry"], 0, "ranges have no odometry")

    def test_a_log_becomes_no_cloud_and_a_cloud_no_log(self):
        self.summary("simulate", "--out", "a.clf", "--speed", "20", "--map-out", "map.csv")
        self.could_not("convert", "a.clf", "b.pcd", says=("slamicp map",))
        self.could_not("convert", "map.csv", "b.clf", says=("no scans",))


if __name__ == "__main__":
    unittest.main()
