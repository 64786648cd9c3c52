# SPDX-License-Identifier: Apache-2.0
"""slamicp_dds (Cyclone DDS) and a robot that speaks Fast DDS, in a network of their own."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

NODE = os.environ.get("SLAMICP_DDS", "slamicp_dds")
PEER = os.environ.get("SLAMICP_DDS_PEER", "slamicp_dds_peer")


# What a user of nav2's amcl has: every name that nav2's configuration guide lists for it, here and there with another
# value; and the sections of others around it.
NAV2 = """
bt_navigator:
  ros__parameters: {{global_frame: map, navigators: [navigate_to_pose]}}
amcl:
  ros__parameters:
    use_sim_time: false
    allow_parameter_qos_overrides: true
    alpha1: 0.2
    alpha2: 0.2
    alpha3: 0.2
    alpha4: 0.2
    alpha5: 0.2
    always_reset_initial_pose: false
    base_frame_id: "base_link"
    beam_skip_distance: 0.5
    beam_skip_error_threshold: 0.9
    beam_skip_threshold: 0.3
    bond_heartbeat_period: 0.25
    do_beamskip: false
    first_map_only: false
    freespace_downsampling: false
    global_frame_id: "map"
    set_initial_pose: true
    initial_pose: {{x: {x}, y: {y}, z: 0.0, yaw: {yaw}}}
    introspection_mode: "disabled"
    service_introspection_mode: "disabled"
    lambda_short: 0.1
    laser_likelihood_max_dist: 2.0
    laser_max_range: 100.0
    laser_min_range: -1.0
    laser_model_type: "likelihood_field"
    map_topic: building
    max_beams: 60
    max_particles: 2000
    min_particles: 500
    odom_frame_id: "odom"
    pf_err: 0.05
    pf_z: 0.99
    random_seed: -1
    recovery_alpha_fast: 0.0
    recovery_alpha_slow: 0.0
    resample_interval: 1
    robot_model_type: "nav2_amcl::DifferentialMotionModel"
    save_pose_rate: -1.0
    scan_topic: front/scan
    sigma_hit: 0.2
    tf_broadcast: true
    transform_tolerance: 1.0
    update_min_a: 0.2
    update_min_d: 0.25
    z_hit: 0.5
    z_max: 0.05
    z_rand: 0.5
    z_short: 0.05
    qos_overrides: {{/tf: {{publisher: {{depth: 100, reliability: reliable}}}}}}
local_costmap:
  local_costmap:
    ros__parameters: {{robot_radius: 0.2}}
"""


def enter_own_network():
    """Participants find each other by multicast: here on loopback, where nobody else is."""
    if os.environ.get("SLAMICP_OWN_NETWORK") == "1":
        return
    os.environ.update(SLAMICP_OWN_NETWORK="1", ROS_DOMAIN_ID="42", PATH="/usr/sbin:/usr/bin:/sbin:/bin")
    for name in ("CYCLONEDDS_URI", "ROS_DISTRO"):
        os.environ.pop(name, None)
    words = ["unshare", "--net"] + ([] if os.geteuid() == 0 else ["--map-root-user"])
    up = 'ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo && exec "$@"'
    os.execvp(words[0], [*words, "sh", "-c", up, "_", sys.executable, "-B", *sys.argv])


enter_own_network()


class DdsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *words, **environment):
        log = open(self.folder / "log", "w+")
        process = subprocess.Popen([NODE, "--ros-args", *map(str, words)], stderr=log,
                                   env={**os.environ, **environment})

        def stop():
            process.terminate()
            self.assertEqual(process.wait(60), 0, "it ends when it is asked to")
            log.close()
        self.addCleanup(stop)
        return process

    def log(self):
        return (self.folder / "log").read_text()

    def wait_for_log(self, line):
        end = time.monotonic() + 30
        while line not in self.log():
            self.assertLess(time.monotonic(), end, self.log())
            time.sleep(0.05)

    def start_at_start(self, *words):
        x, y, theta = self.peer("start").split()
        return self.start("-p", "odometry_wait:=10.0", "-p", "scan_timeout:=1000", "-p", f"initial_pose_x:={x}",
                          "-p", f"initial_pose_y:={y}", "-p", f"initial_pose_a:={theta}", *words)

    def peer(self, *words):
        told = subprocess.run([PEER, *map(str, words)], capture_output=True, text=True, timeout=240)
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)
        return told.stdout

    def refused(self, *words, **environment):
        told = subprocess.run([NODE, "--ros-args", *map(str, words)], capture_output=True, text=True, timeout=60,
                              env={**os.environ, **environment})
        self.assertEqual(told.returncode, 1)
        return told.stderr

    def test_map_tf_and_scans_in_poses_tf_and_clouds_out(self):
        node = self.start_at_start()
        self.assertIn("agree: 100 scans", self.peer("tf"))
        self.assertIsNone(node.poll(), "the node is alive")

    def test_a_namespace_a_file_of_parameters_and_time_that_is_played(self):
        self.peer("map", self.folder / "room.pcd")
        parameters = self.folder / "robot.yaml"
        parameters.write_text(f"""
            /**:
              ros__parameters:
                use_sim_time: true
                odometry_wait: 10.0
                scan_timeout: 1000
                map_file: "{self.folder}/room.pcd"
            localization:
              ros__parameters:
                odom_topic: odom
                wait_for_initial_pose: true
                scan_topics: [front]
            another:
              ros__parameters: {{max_iterations: 1, what_nobody_knows: 3}}
        """)
        node = self.start("--params-file", parameters, "-r", "__node:=localization", "-r", "__ns:=/robot/", "-r",
                          "front:=scan", ROS_DISTRO="humble")
        self.assertIn("agree: 100 scans", self.peer("odom", self.folder / "room.pcd"))
        self.assertIsNone(node.poll(), "the node is alive")

    def test_two_lasers(self):
        self.start_at_start("-p", "scan_topics:=[front, back]")
        self.assertIn("agree: 30 scans", self.peer("lasers"))

    def test_the_parameters_of_nav2s_amcl(self):
        x, y, theta = self.peer("start").split()
        parameters = self.folder / "nav2_params.yaml"
        parameters.write_text(NAV2.format(x=x, y=y, yaw=theta))
        self.start("--params-file", parameters, "-r", "__node:=amcl", "-p", "odometry_wait:=10.0", "-p",
                   "scan_timeout:=1000", "-r", "front/scan:=scan", "-r", "building:=/map", "--enclave", "/", "--log-level",
                   "amcl:=info", "--enable-rosout-logs")
        self.assertIn("agree: 30 scans", self.peer("amcl"))
        self.assertIn("'sigma_hit' has no use here", self.log())
        self.assertNotIn("'scan_topic'", self.log())

    def test_a_file_with_namespaces(self):
        parameters = self.folder / "robots.yaml"
        parameters.write_text("""
            robot: {amcl: {ros__parameters: {max_iterations: 0}}}
            /other: {amcl: {ros__parameters: {gravity: 9.81}}}
        """)
        words = ["--params-file", parameters, "-r", "__node:=amcl"]
        self.assertIn("'max_iterations' is 0", self.refused(*words, "-r", "__ns:=/robot"))
        self.assertIn("no parameter 'gravity'", self.refused(*words, "-r", "__ns:=/other"))

    def test_mapping(self):
        self.start_at_start("-p", "mode:=mapping", "-p", "map_update_interval:=0.1")
        self.assertIn("agree: 30 scans", self.peer("mapping"))

    def test_who_promises_less_is_not_heard_and_told_of(self):
        self.start()
        self.peer("lesser")
        self.wait_for_log("/tf: somebody publishes it best effort, and is not heard: it must be reliable")
        self.wait_for_log("/map: somebody publishes it volatile, and is not heard: it must be transient local")

    def test_what_it_does_not_know_is_refused(self):
        self.assertIn("'odom_frame_id'", self.refused("-p", "odom_frame:=odom"), "the nearest name")
        self.assertIn("'max_iterations' is a int", self.refused("-p", "max_iterations:='7'"), "quoted: a text")
        self.assertIn("'max_iterations' is 0", self.refused("-p", "max_iterations:=0"))
        self.assertIn("NAME:=VALUE", self.refused("-p", "deskew=true"))
        self.assertIn("nowhere.yaml", self.refused("--params-file", self.folder / "nowhere.yaml"))
        self.assertIn("ROS_DOMAIN_ID", self.refused(ROS_DOMAIN_ID="233"))
        self.assertIn("'--scan'", self.refused("--scan"))


if __name__ == "__main__":
    unittest.main()
