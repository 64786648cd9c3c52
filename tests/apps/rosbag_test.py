# SPDX-License-Identifier: Apache-2.0
"""ROS 1 bags as ROS itself writes and reads them: Debian's python3-rosbag is the oracle."""
import math
import os
import struct
import sys
import unittest

from command import CommandTest, data_dir

try:
    import genpy
    import rosbag
    from geometry_msgs.msg import TransformStamped
    from nav_msgs.msg import Odometry
    from sensor_msgs.msg import LaserScan
    from tf2_msgs.msg import TFMessage
    MISSING = None
except ImportError as problem:
    MISSING = f"{problem}: install python3-rosbag, python3-sensor-msgs, python3-nav-msgs and python3-tf2-msgs"

DATA = data_dir()
START = 1_600_000_000


def stamp(number):
    return genpy.Time(START + number // 10, number % 10 * 100_000_000 + number)


def scan_message(number):
    scan = LaserScan()
    scan.header.seq, scan.header.stamp, scan.header.frame_id = number, stamp(number), "laser"
    scan.angle_min, scan.angle_max, scan.angle_increment = -2.0, 2.0, 0.01
    scan.time_increment, scan.scan_time, scan.range_min, scan.range_max = 0.0001, 0.1, 0.1, 25.0
    scan.ranges = [2.0 + math.sin(0.1 * number + 0.01 * beam) for beam in range(401)]
    scan.ranges[number % 401] = math.inf
    scan.intensities = [float(beam) for beam in range(401)]
    return scan


def odometry_message(number):
    odometry = Odometry()
    odometry.header.stamp, odometry.header.frame_id, odometry.child_frame_id = stamp(number), "odom", "base_link"
    odometry.pose.pose.position.x, odometry.pose.pose.orientation.w = 0.1 * number, 1.0
    return odometry


def mount_message():
    mount = TransformStamped()
    mount.header.stamp, mount.header.frame_id, mount.child_frame_id = stamp(0), "base_link", "laser"
    mount.transform.translation.x = 0.25
    mount.transform.rotation.z, mount.transform.rotation.w = math.sin(0.2), math.cos(0.2)
    return TFMessage([mount])


def write_bag(path, compression):
    """200 scans in several chunks."""
    with rosbag.Bag(str(path), "w", compression=compression, chunk_threshold=60_000) as bag:
        bag.write("/tf_static", mount_message(), stamp(0))
        for number in range(200):
            bag.write("/odom", odometry_message(number), stamp(number))
            bag.write("/scan", scan_message(number), stamp(number))


def float32(numbers):
    """As bytes, to compare bit by bit."""
    return struct.pack(f"<{len(numbers)}f", *numbers)


def ranges_told(message):
    """What a ranges CSV says of a message: 0 where nothing came back, as is_return of laser_scan.hpp."""
    return [r if max(0.0, message.range_min) <= r < message.range_max else 0.0 for r in message.ranges]


@unittest.skipIf(MISSING is not None, MISSING)
class RosbagIsTheOracle(CommandTest):
    def compare(self, bag_file, topic):
        """Stamps and ranges of a bag as rosbag gives them, and as the command does."""
        with rosbag.Bag(str(bag_file)) as bag:
            messages = [message for _, message, _ in bag.read_messages(topics=[topic])]
        self.done("convert", bag_file, "told.csv", "--scan-topic", topic)
        self.done("convert", bag_file, "told.clf", "--scan-topic", topic)
        rows = self.numbers("told.csv")
        self.assertEqual(len(rows), len(messages))
        lines = [line.split() for line in self.read("told.clf").splitlines() if line.startswith("ROBOTLASER1")]
        self.assertEqual(len(lines), len(messages))
        for row, line, message in zip(rows, lines, messages):
            self.assertEqual(float32(row), float32(ranges_told(message)))
            self.assertAlmostEqual(float(line[-3]), message.header.stamp.to_sec(), delta=2e-6)
        return messages

    def test_bags_written_by_rosbag(self):
        for compression in ("none", "lz4", "bz2"):
            with self.subTest(compression=compression):
                write_bag(self.folder / "run.bag", compression)
                self.assertEqual(len(self.compare(self.folder / "run.bag", "/scan")), 200)
                told = self.summary("info", "run.bag")
                self.assertEqual((told["scans"], told["scans_with_odometry"]), (200, 200))
                self.assertEqual(told["problems"], [])
                self.assertAlmostEqual(told["laser_offset"]["x"], 0.25, places=6)
                self.assertAlmostEqual(told["laser_offset"]["theta"], 0.4, places=6)
                self.assertAlmostEqual(told["odometry_path"], 19.9, places=5)

    def test_a_bag_that_was_never_closed(self):
        write_bag(self.folder / "run.bag", "none")
        whole = (self.folder / "run.bag").read_bytes()
        (self.folder / "cut.bag").write_bytes(whole[:len(whole) // 2])
        told = self.summary("info", "cut.bag")
        self.assertGreater(told["scans"], 80)
        self.assertLess(told["scans"], 120)
        self.assertIn("is cut or damaged at byte", told["problems"][0])

    def test_bags_of_robots(self):
        if DATA is None:
            return
        for name, topic, scans in (("hokuyo/birmingham_trace0.bag", "/base_scan", 958),
                                   ("hokuyo/scan_tools_demo.bag", "/scan", 360),
                                   ("obstacles/leg_positive_1_extracted.bag", "/training_scan", 197)):
            with self.subTest(name=name):
                if (DATA / name).exists():
                    self.assertEqual(len(self.compare(DATA / name, topic)), scans)


if __name__ == "__main__":
    if MISSING is not None and os.environ.get("CI") == "true":
        sys.exit(MISSING)
    unittest.main()
