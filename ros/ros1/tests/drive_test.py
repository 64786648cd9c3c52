# SPDX-License-Identifier: Apache-2.0
"""The simulator as a ROS robot: an agent drives the reference path by what the node publishes, and stands before a box
in its way; the box taken away, it goes on."""
import math
import os
import subprocess
import unittest

from ros_world import RosTest, enter_own_network, start_master, stop, wait_for

enter_own_network()

import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from nav_msgs.msg import Odometry
from slamicp_msgs.msg import Obstacles
from std_msgs.msg import Float64
from std_srvs.srv import Empty

DRIVE = os.environ.get("SLAMICP_ROBOT", "slamicp_ros_drive")
BOX_AHEAD, HALF_BOX = 4.0, 0.15
GOES_ON = 7.0


class DriveTest(RosTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(stop, start_master())
        rospy.init_node("test", disable_signals=True)
        self.heard = {}
        for topic, kind in (("truth", PoseStamped), ("amcl_pose", PoseWithCovarianceStamped), ("odom", Odometry),
                            ("obstacles", Obstacles), ("travelled", Float64)):
            self.heard[topic] = []
            rospy.Subscriber(topic, kind, self.heard[topic].append, queue_size=10000, tcp_nodelay=True)

    def run_drive(self, role):
        process = subprocess.Popen([DRIVE, role])
        self.addCleanup(stop, process)
        return process

    def travelled(self):
        return self.heard["travelled"][-1].data if self.heard["travelled"] else 0.0

    def stands(self):
        last = [each.data for each in self.heard["travelled"][-40:]]
        return len(last) == 40 and last[-1] > 1.0 and max(last) - min(last) < 0.005

    def test_the_agent_drives_and_stands_before_a_box(self):
        written = subprocess.run([DRIVE, "map", str(self.folder / "corridor.pcd")], check=True, capture_output=True,
                                 text=True)
        x, y, theta = map(float, written.stdout.split())
        self.run_drive("agent")
        node = self.start(map_file=self.folder / "corridor.pcd", initial_pose_x=x, initial_pose_y=y,
                          initial_pose_a=theta)
        self.run_drive("robot")  # it waits for who wants its scans
        self.assertTrue(wait_for(self.stands, 60.0), f"{self.travelled()} m")
        stood_at = self.travelled()
        self.assertLess(stood_at, BOX_AHEAD - HALF_BOX - 0.4)
        self.assertGreater(stood_at, BOX_AHEAD - 1.6)
        self.assertTrue(self.heard["obstacles"][-1].obstacles)

        rospy.ServiceProxy("remove_box", Empty)()
        self.assertTrue(wait_for(lambda: self.travelled() > GOES_ON, 60.0), f"{self.travelled()} m")
        self.assertIsNone(node.poll())
        self.assertTrue(self.heard["odom"])
        truth = {each.header.stamp: each.pose.position for each in self.heard["truth"]}
        errors = sorted(math.hypot(pose.pose.pose.position.x - truth[pose.header.stamp].x,
                                   pose.pose.pose.position.y - truth[pose.header.stamp].y)
                        for pose in self.heard["amcl_pose"] if pose.header.stamp in truth)
        self.assertGreater(len(errors), 300)
        self.assertLess(errors[len(errors) // 2], 0.01, "median")
        self.assertLess(errors[-1], 0.05, "worst")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
