# SPDX-License-Identifier: Apache-2.0
"""The node with a real master: a robot's recording in the map of another one, amcl's launch file, what goes wrong."""
import csv
import json
import math
import pathlib
import subprocess
import unittest

from ros_world import NODE, RosTest, data_dir, enter_own_network, start_master, stop, wait_for

enter_own_network()

import rosbag
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import SetMap
from sensor_msgs.msg import LaserScan, PointCloud2
from slamicp_msgs.msg import Obstacles, Status
from slamicp_msgs.srv import SaveMap
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

HOKUYO = data_dir() / "hokuyo" if data_dir() else None
START = {"initial_pose_x": -0.4, "initial_pose_y": 0.0, "initial_pose_a": -0.06}
START_WORD = "-0.4,0,-0.06"

# Every parameter that amcl 1.17 documents, as launch files for it give them.
AMCL_LAUNCH = """<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="base_scan"/>
    <remap from="map" to="/server/map"/>
    <param name="odom_model_type" value="diff"/> <param name="odom_alpha5" value="0.1"/>
    <param name="gui_publish_rate" value="10.0"/> <param name="laser_max_beams" value="30"/>
    <param name="laser_min_range" value="-1.0"/> <param name="laser_max_range" value="-1.0"/>
    <param name="min_particles" value="500"/> <param name="max_particles" value="5000"/>
    <param name="kld_err" value="0.05"/> <param name="kld_z" value="0.99"/>
    <param name="odom_alpha1" value="0.2"/> <param name="odom_alpha2" value="0.2"/>
    <param name="odom_alpha3" value="0.8"/> <param name="odom_alpha4" value="0.2"/>
    <param name="laser_z_hit" value="0.5"/> <param name="laser_z_short" value="0.05"/>
    <param name="laser_z_max" value="0.05"/> <param name="laser_z_rand" value="0.5"/>
    <param name="laser_sigma_hit" value="0.2"/> <param name="laser_lambda_short" value="0.1"/>
    <param name="laser_model_type" value="likelihood_field"/> <param name="laser_likelihood_max_dist" value="2.0"/>
    <param name="update_min_d" value="0.2"/> <param name="update_min_a" value="0.5"/>
    <param name="odom_frame_id" value="odom"/> <param name="base_frame_id" value="base_link"/>
    <param name="global_frame_id" value="map"/> <param name="resample_interval" value="1"/>
    <param name="transform_tolerance" value="0.2"/> <param name="recovery_alpha_slow" value="0.0"/>
    <param name="recovery_alpha_fast" value="0.0"/> <param name="use_map_topic" value="true"/>
    <param name="first_map_only" value="false"/> <param name="tf_broadcast" value="true"/>
    <param name="save_pose_rate" value="0.5"/> <param name="selective_resampling" value="false"/>
    <param name="do_beamskip" value="false"/> <param name="beam_skip_distance" value="0.5"/>
    <param name="beam_skip_threshold" value="0.3"/> <param name="beam_skip_error_threshold" value="0.9"/>
    <param name="restore_defaults" value="false"/> <param name="bag_scan_period" value="-1.0"/>
    <param name="std_warn_level_x" value="0.2"/> <param name="std_warn_level_y" value="0.2"/>
    <param name="std_warn_level_yaw" value="0.1"/> <param name="force_update_after_initialpose" value="false"/>
    <param name="initial_pose_x" value="-0.4"/> <param name="initial_pose_y" value="0.0"/>
    <param name="initial_pose_a" value="-0.06"/> <param name="initial_cov_xx" value="0.25"/>
    <param name="initial_cov_yy" value="0.25"/> <param name="initial_cov_aa" value="0.07"/>
  </node>
</launch>
"""


def heading(quaternion):
    return 2.0 * math.atan2(quaternion.z, quaternion.w)


def is_scan(message):
    return message._type == "sensor_msgs/LaserScan"  # a recording's messages have classes of their own


class Robot:
    """Plays a recording as fast as the node answers, and keeps what it says."""

    def __init__(self, bag):
        self.messages = []
        with rosbag.Bag(str(bag)) as recording:
            for topic, message, _ in recording.read_messages(["/base_scan", "/tf"]):
                if topic == "/tf":  # but for what the robot's own localization said
                    message.transforms = [each for each in message.transforms if each.header.frame_id != "map"]
                if topic != "/tf" or message.transforms:
                    self.messages.append(message)
        self.scan = rospy.Publisher("base_scan", LaserScan, queue_size=1000, tcp_nodelay=True)
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=1000, tcp_nodelay=True)
        self.heard = {}
        for topic, kind in (("amcl_pose", PoseWithCovarianceStamped), ("outliers", PointCloud2),
                            ("inliers", PointCloud2), ("obstacles", Obstacles), ("obstacle_markers", MarkerArray),
                            ("slamicp/status", Status), ("/diagnostics", DiagnosticArray), ("/tf", TFMessage),
                            ("map", OccupancyGrid)):
            self.heard[topic] = []
            rospy.Subscriber(topic, kind, self.heard[topic].append, queue_size=10000, tcp_nodelay=True)

    def forget(self):
        for list_of in self.heard.values():
            list_of.clear()

    def poses(self):
        return self.heard["amcl_pose"]

    def corrections(self):
        return [each for message in self.heard["/tf"] for each in message.transforms if each.header.frame_id == "map"]

    def is_connected(self):
        return self.scan.get_num_connections() > 0 and self.tf.get_num_connections() > 1  # it hears itself too

    def play(self, scans, ahead=20):
        """The first scans, and what lies between; never more than `ahead` of the answers."""
        sent = 0
        for message in self.messages:
            if is_scan(message):
                if sent == scans:
                    break
                sent += 1
                self.scan.publish(message)
            else:
                self.tf.publish(message)
            if not wait_for(lambda: len(self.poses()) >= sent - ahead, every=0.001):
                return False
        for message in [each for each in self.messages if not is_scan(each)]:
            stamp = message.transforms[0].header.stamp
            last = [each for each in self.messages if is_scan(each)][scans - 1].header.stamp
            if last < stamp < last + rospy.Duration(0.4):  # the odometry that the last scan waits for
                self.tf.publish(message)
        return wait_for(lambda: len(self.poses()) >= scans)


@unittest.skipUnless(HOKUYO, "no real data here")
class NodeTest(RosTest):
    @classmethod
    def setUpClass(cls):
        cls.master = start_master()
        rospy.init_node("robot", disable_signals=True)
        cls.robot = Robot(HOKUYO / "birmingham_trace1.bag")

    @classmethod
    def tearDownClass(cls):
        rospy.signal_shutdown("done")
        stop(cls.master)

    def make_map(self, name):
        self.slamicp("map", HOKUYO / "birmingham_trace0.bag", "--out", name)
        return self.folder / name

    def assert_at_start(self, pose, within=0.3):
        self.assertAlmostEqual(pose.pose.pose.position.x, START["initial_pose_x"], delta=within)
        self.assertAlmostEqual(pose.pose.pose.position.y, START["initial_pose_y"], delta=within)

    def cut(self, scans, name):
        """The recording until so many scans, with the odometry that they need."""
        with rosbag.Bag(str(HOKUYO / "birmingham_trace1.bag")) as whole, rosbag.Bag(str(self.folder / name), "w") as cut:
            count, last = 0, None
            for topic, message, stamp in whole.read_messages(["/base_scan", "/odom", "/tf"]):
                if topic == "/base_scan":
                    count += 1
                    if count > scans:
                        continue
                    last = message.header.stamp
                elif topic == "/odom" and count > scans and message.header.stamp > last + rospy.Duration(1.0):
                    break
                cut.write(topic, message, stamp)
        return self.folder / name

    def test_the_node_and_the_command_give_the_same_poses(self):
        scans = 600
        world = self.make_map("trace0.pcd")
        self.robot.forget()
        node = self.start("scan:=base_scan", map_file=world, odometry_wait=10.0, **START)
        self.assertTrue(wait_for(self.robot.is_connected, 60.0))
        self.assertTrue(self.robot.play(scans), f"{len(self.robot.poses())} poses")
        poses = self.robot.poses()
        self.assertEqual(len(poses), scans)

        json_of = {}
        for until in (60, scans):
            bag = self.cut(until, f"cut{until}.bag")
            json_of[until] = json.loads(self.slamicp("localize", bag, "--map", world, "--initial-pose", START_WORD,
                                                     "--recover", "--metrics", "metrics.csv", "--json", "-"))
            self.assertEqual(json_of[until]["scans"], until)
            found, last = poses[until - 1].pose.pose, json_of[until]["last_pose"]
            self.assertAlmostEqual(found.position.x, last["x"], delta=1e-9)
            self.assertAlmostEqual(found.position.y, last["y"], delta=1e-9)
            self.assertAlmostEqual(heading(found.orientation), last["theta"], delta=1e-9)
        with open(self.folder / "metrics.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for pose, row in zip(poses, rows):  # as far as its digits go
            self.assertAlmostEqual(pose.pose.pose.position.x, float(row["x"]), delta=6e-7)
            self.assertAlmostEqual(pose.pose.pose.position.y, float(row["y"]), delta=6e-7)
            self.assertAlmostEqual(pose.pose.covariance[0], float(row["var_x"]), delta=1e-11)
            self.assertAlmostEqual(pose.header.stamp.to_sec(), float(row["stamp"]), delta=2e-6)

        # All other topics tell of the same scans.
        heard = self.robot.heard
        for topic in ("outliers", "inliers", "obstacles", "obstacle_markers", "slamicp/status"):
            self.assertTrue(wait_for(lambda t=topic: len(heard[t]) >= scans), topic)
        self.assertEqual(len(self.robot.corrections()), scans)
        self.assertEqual(sum(cloud.width for cloud in heard["outliers"][:scans]),
                         sum(int(row["outliers"]) for row in rows))
        self.assertEqual(heard["outliers"][0].header.frame_id, "laser")
        status = heard["slamicp/status"][scans - 1]
        self.assertEqual(status.dropped, 0)
        self.assertEqual(status.scans, scans)
        self.assertTrue(any(each.obstacles for each in heard["obstacles"]))
        self.assertTrue(wait_for(lambda: heard["/diagnostics"]))
        self.assertEqual(len(heard["map"]), 1, "the file's map")

        # The clock of a recording that begins again.
        self.robot.forget()
        self.assertTrue(self.robot.play(20))
        self.assert_at_start(self.robot.poses()[0])
        self.robot.forget()
        rospy.ServiceProxy("request_nomotion_update", Empty)()
        self.assertTrue(wait_for(lambda: len(self.robot.poses()) == 1))
        self.assertIsNone(node.poll(), "the node is alive")

    def test_a_launch_file_for_amcl_runs_with_only_package_and_type_changed(self):
        self.start("__ns:=/server", name="server", map_file=self.make_map("trace0.yaml"), tf_broadcast=False)
        launch = self.folder / "amcl.launch"
        launch.write_text(AMCL_LAUNCH.replace('pkg="amcl" type="amcl"', 'pkg="slamicp_ros" type="slamicp_node"'))
        self.robot.forget()
        launched = subprocess.Popen(["roslaunch", "--wait", str(launch)], stdout=subprocess.DEVNULL)
        self.addCleanup(stop, launched)
        self.assertTrue(wait_for(self.robot.is_connected, 60.0))
        states = self.robot.heard["slamicp/status"]
        self.assertTrue(wait_for(lambda: states and states[-1].state == "waiting_for_scan"), states[-1:])
        self.assertTrue(self.robot.play(100, ahead=5))
        pose = self.robot.poses()[-1]
        self.assertEqual(pose.header.frame_id, "map")
        self.assertGreater(self.robot.heard["slamicp/status"][-1].probability, 0.9)
        correction = self.robot.corrections()[-1]
        self.assertEqual(correction.child_frame_id, "odom")
        self.assertAlmostEqual((correction.header.stamp - pose.header.stamp).to_sec(), 0.2, places=6)
        # As amcl, it writes the pose where the next start finds it.
        self.assertTrue(wait_for(lambda: rospy.get_param("/amcl/initial_pose_x", -0.4) != -0.4, 5.0))

        # Another map while it runs: the pose stays.
        grid = rospy.wait_for_message("/server/map", OccupancyGrid, 10.0)
        another = rospy.Publisher("/server/map", OccupancyGrid, queue_size=1, latch=True)
        another.publish(grid)

        def maps():
            values = [each.values for each in self.robot.heard["/diagnostics"][-1].status]
            return {pair.key: pair.value for pair in values[0]}.get("maps")
        self.assertTrue(wait_for(lambda: maps() == "2"), maps())
        # Or by the service, with a pose.
        start = PoseWithCovarianceStamped()
        start.header.frame_id = "map"
        start.pose.pose.position.x = START["initial_pose_x"]
        start.pose.pose.orientation.w = 1.0
        self.assertTrue(rospy.ServiceProxy("set_map", SetMap)(grid, start).success)
        self.assertTrue(wait_for(lambda: maps() == "3"), maps())
        grid.data = []
        self.assertFalse(rospy.ServiceProxy("set_map", SetMap)(grid, start).success)
        # Where it was put by hand, a metre beside, it does not stay.
        hand = PoseWithCovarianceStamped()
        hand.header.frame_id = "map"
        hand.pose.pose.position.x = START["initial_pose_x"] + 0.5
        hand.pose.pose.position.y = START["initial_pose_y"] + 0.5
        hand.pose.pose.orientation.w = 1.0
        by_hand = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        self.assertTrue(wait_for(lambda: by_hand.get_num_connections() > 0))
        by_hand.publish(hand)
        self.robot.forget()
        self.assertTrue(self.robot.play(60, ahead=5), "and the recording begins again")
        self.assertLess(self.robot.heard["slamicp/status"][-1].dropped, 1)
        self.assertIsNone(launched.poll(), "the node is alive")

    def test_a_map_is_made_published_and_saved(self):
        self.robot.forget()
        self.start("scan:=base_scan", mode="mapping", odometry_wait=10.0)
        self.assertTrue(wait_for(self.robot.is_connected, 60.0))
        self.assertTrue(self.robot.play(80))
        self.assertTrue(wait_for(lambda: self.robot.heard["map"]))
        save = rospy.ServiceProxy("save_map", SaveMap)
        self.assertTrue(save(str(self.folder / "made.yaml")).success)
        refused = save("/nowhere/at/all.yaml")
        self.assertFalse(refused.success)
        self.assertTrue(refused.message)
        info = json.loads(self.slamicp("info", "made.yaml", "--json", "-"))
        self.assertGreater(json.dumps(info).count("occupied"), 0)

    def test_an_unknown_parameter_is_refused_with_the_nearest_name(self):
        result = subprocess.run([NODE, "__name:=refused", "_odom_frame:=odom"], capture_output=True, text=True, timeout=20)
        self.assertEqual(result.returncode, 1)
        self.assertIn("'odom_frame_id'", result.stdout + result.stderr)

    def test_the_documentation_lists_all_parameters(self):
        told = subprocess.run([NODE, "--parameters"], capture_output=True, text=True, check=True).stdout
        page = pathlib.Path(__file__).resolve().parents[3] / "docs/ros.md"
        self.assertIn(told.strip(), page.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(warnings="ignore")
