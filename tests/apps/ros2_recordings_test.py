# SPDX-License-Identifier: Apache-2.0
"""Recordings of ROS 2 that others have written: databases by Python's sqlite3, MCAP by the library of its makers (npm)."""
import json
import math
import os
import pathlib
import shutil
import sqlite3
import struct
import subprocess
import unittest

from command import CommandTest

ORACLE = pathlib.Path(__file__).parents[1] / "oracles" / "mcap"
BEAMS = 301


def scans_of(count):
    """Ranges that 32 bits hold as they are."""
    return [{"stamp": 1700000000.25 + i, "ranges": [1.0 + ((i * 7 + beam * 3) % 160) / 16.0 for beam in range(BEAMS)]}
            for i in range(count)]


class Cdr:
    """A message's fields one after the other, each where its size divides the offset."""

    def __init__(self):
        self.data = b""

    def put(self, kind, *values):
        size = struct.calcsize(kind)
        for value in values:
            self.data += bytes(-len(self.data) % size) + struct.pack("<" + kind, value)
        return self

    def text(self, text):
        self.put("I", len(text) + 1)
        self.data += text.encode() + b"\0"
        return self

    def header(self, stamp, frame):
        return self.put("i", int(stamp)).put("I", round((stamp - int(stamp)) * 1e9)).text(frame)

    def message(self):
        return b"\0\1\0\0" + self.data


def scan_message(scan):
    out = Cdr().header(scan["stamp"], "laser").put("f", -1.5, 1.5, 0.01, 0.0, 0.1, 0.05, 30.0)
    return out.put("I", BEAMS).put("f", *scan["ranges"]).put("I", 0).message()


def odometry_message(stamp, x, y, theta):
    out = Cdr().header(stamp, "odom").text("base_link").put("d", x, y, 0.0)
    return out.put("d", 0.0, 0.0, math.sin(theta / 2), math.cos(theta / 2)).put("d", *[0.0] * (36 + 6 + 36)).message()


def write_database(path, scans):
    database = sqlite3.connect(path)
    database.executescript(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
        "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL,"
        "data BLOB NOT NULL);"
        "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
        "INSERT INTO topics VALUES(1,'/scan','sensor_msgs/msg/LaserScan','cdr','');"
        "INSERT INTO topics VALUES(2,'/odom','nav_msgs/msg/Odometry','cdr','');")
    rows = []
    for i, scan in enumerate(scans):
        nanoseconds = round(scan["stamp"] * 4) * 250000000
        rows.append((1, nanoseconds, scan_message(scan)))
        rows.append((2, nanoseconds, odometry_message(scan["stamp"], 0.5 * i, 0.25, 0.0)))
    rows.reverse()  # what counts is the stamp
    database.executemany("INSERT INTO messages(topic_id,timestamp,data) VALUES(?,?,?)", rows)
    database.commit()
    database.close()


class Ros2Recordings(CommandTest):
    def check_scans(self, recording, scans):
        self.done("convert", recording, "out.csv")
        for mine, theirs in zip(self.numbers("out.csv"), scans, strict=True):
            self.assertEqual(mine, theirs["ranges"])

    def test_a_database_of_sqlite3(self):
        scans = scans_of(40)
        write_database(self.folder / "run.db3", scans)
        before = sorted(os.listdir(self.folder))
        told = self.summary("info", "run.db3")
        self.assertEqual(sorted(os.listdir(self.folder)), before, "files were made beside it")
        self.assertEqual((told["scans"], told["scans_with_odometry"]), (40, 40))
        self.check_scans("run.db3", scans)

    def test_a_folder_of_two_databases(self):
        scans = scans_of(30)
        (self.folder / "run").mkdir()
        write_database(self.folder / "run" / "run_0.db3", scans[:20])
        write_database(self.folder / "run" / "run_1.db3", scans[20:])
        self.write("run/metadata.yaml", "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
                                        "  relative_file_paths:\n    - run_0.db3\n    - run_1.db3\n")
        self.check_scans("run", scans)
        (self.folder / "run" / "metadata.yaml").unlink()
        self.assertIn("no metadata.yaml", self.done("info", "run").stdout)
        self.check_scans("run", scans)

    def test_mcap_of_its_makers(self):
        if missing := self.oracle_is_missing():
            if os.environ.get("CI") == "true":
                self.fail(missing)
            self.skipTest(missing)
        scans = scans_of(40)
        self.write("scans.json", json.dumps(scans))
        for compression in ("none", "lz4", "zstd"):
            with self.subTest(compression=compression):
                subprocess.run(["node", "oracle/write.mjs", "scans.json", "run.mcap", compression], cwd=self.folder,
                               check=True, timeout=60)
                self.assertEqual(self.summary("info", "run.mcap")["scans"], 40)
                self.check_scans("run.mcap", scans)

    def oracle_is_missing(self):
        """Installs the oracle in the test's folder; says why where that cannot be."""
        if not shutil.which("npm") or not shutil.which("node"):
            return "skipped: no npm here"
        shutil.copytree(ORACLE, self.folder / "oracle")
        result = subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"],
                                cwd=self.folder / "oracle", capture_output=True, text=True, timeout=240)
        return None if result.returncode == 0 else f"skipped: npm ci cannot: {result.stderr.strip()[-300:]}"


if __name__ == "__main__":
    unittest.main()
