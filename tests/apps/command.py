# SPDX-License-Identifier: Apache-2.0
"""What the tests of the command share. SLAMICP names the program to test."""
import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("SLAMICP", "slamicp")
VERBS = ("demo", "info", "convert", "simulate", "map", "localize", "align", "odometry", "evaluate",
         "experiment")

OUTLIERS_HEADER = "scan,stamp,beam,x,y,distance,kind"
METRICS_HEADER = ("scan,stamp,x,y,theta,stop,iterations,points,inliers,outliers,mean_inlier_distance,time_us,"
                  "state,probability,var_x,var_y,var_theta,blind_deg")
OBSTACLES_HEADER = "scan,stamp,id,kind,x,y,width,depth,heading,radius,points,speed,state"


def data_dir():
    """Where the real data lie, or None."""
    name = os.environ.get("SLAMICP_DATA_DIR") or os.environ.get("SLAMICP_DEFAULT_DATA_DIR")
    return pathlib.Path(name) if name and os.path.isdir(name) else None


def run(*words, folder):
    return subprocess.run([PROGRAM, *map(str, words)], cwd=folder, capture_output=True, text=True, timeout=300)


class CommandTest(unittest.TestCase):
    """Every test runs in an empty folder of its own, and leaves no hidden file in it."""

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def tearDown(self):
        hidden = [name for name in os.listdir(self.folder) if name.startswith(".")]
        self.assertEqual(hidden, [], "half-written files were left")

    def run_command(self, *words):
        return run(*words, folder=self.folder)

    def done(self, *words):
        """The command does it; gives what it says."""
        result = self.run_command(*words)
        self.assertEqual(result.returncode, 0, f"{words}\n{result.stdout}{result.stderr}")
        return result

    def summary(self, *words):
        """What --json - gives: JSON and nothing else on stdout."""
        return json.loads(self.done(*words, "--json", "-").stdout)

    def could_not(self, *words, says=()):
        """The command says on stderr why it cannot, and exits with 1."""
        return self.fails(1, *words, says=("slamicp: ", *says))

    def wrong_words(self, *words, says=()):
        return self.fails(2, *words, says=says)

    def fails(self, status, *words, says=()):
        result = self.run_command(*words)
        self.assertEqual(result.returncode, status, f"{words}\n{result.stdout}{result.stderr}")
        for text in says:
            self.assertIn(text, result.stderr)
        self.assertEqual(result.stdout, "")
        return result

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def read(self, name):
        return (self.folder / name).read_text()

    def table(self, name, header):
        """The rows of a CSV file under exactly this header."""
        lines = self.read(name).splitlines()
        self.assertEqual(lines[0], header)
        rows = list(csv.DictReader(lines))
        for row in rows:
            self.assertNotIn(None, row.values(), "a field is missing")
            self.assertNotIn(None, row, "there is a field too many")
        return rows

    def numbers(self, name):
        """Rows of numbers, between commas or blanks."""
        return [[float(word) for word in line.replace(",", " ").split()] for line in self.read(name).splitlines()]

    def trajectory(self, name):
        """(stamp, x, y, theta) of a TUM file, all of whose lines are checked."""
        poses = []
        for line in self.read(name).splitlines():
            words = line.split(" ")
            self.assertEqual(len(words), 8)
            self.assertEqual(len(words[0].partition(".")[2]), 6, "stamps have 6 decimals")
            stamp, x, y, z, qx, qy, qz, qw = map(float, words)
            self.assertEqual((z, qx, qy), (0.0, 0.0, 0.0))
            self.assertAlmostEqual(qz * qz + qw * qw, 1.0, places=6)
            poses.append((stamp, x, y, math.remainder(2.0 * math.atan2(qz, qw), math.tau)))
        return poses


def pose_words(pose):
    """A pose as --initial-pose takes it, from a --json summary."""
    return f"{pose['x']},{pose['y']},{pose['theta']}"


def moved(pose, point):
    """The point in the frame that the pose (x, y, theta) maps to."""
    x, y, theta = pose
    c, s = math.cos(theta), math.sin(theta)
    return (x + c * point[0] - s * point[1], y + s * point[0] + c * point[1])
