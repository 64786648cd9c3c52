# SPDX-License-Identifier: Apache-2.0
"""A master that is started again: the node lives, and is found anew."""
import unittest

from ros_world import RosTest, enter_own_network, start_master, stop, wait_for

enter_own_network()

import rosgraph


class MasterTest(RosTest):
    def test_the_node_registers_anew(self):
        first = start_master()
        node = self.start(name="slamicp", use_map_topic=True)
        registered = lambda: any(topic == "/amcl_pose" for topic, _ in rosgraph.Master("/test").getSystemState()[0])
        self.assertTrue(wait_for(registered))
        stop(first)
        self.assertIsNone(node.poll(), "the node lives without a master")
        second = start_master()
        self.addCleanup(stop, second)

        def is_whole():
            publishers, subscribers, services = ({name for name, nodes in kind if "/slamicp" in nodes}
                                                 for kind in rosgraph.Master("/test").getSystemState())
            return (publishers >= {"/tf", "/amcl_pose", "/slamicp/status", "/obstacles", "/diagnostics"} and
                    subscribers >= {"/scan", "/tf", "/tf_static", "/map", "/initialpose"} and
                    services >= {"/save_map", "/set_map", "/request_nomotion_update"})
        self.assertTrue(wait_for(is_whole), "the new master knows the node")
        self.assertIsNone(node.poll())


if __name__ == "__main__":
    unittest.main(warnings="ignore")
