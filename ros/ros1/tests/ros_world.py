# SPDX-License-Identifier: Apache-2.0
"""What the tests over ROS share: a network and a master of their own, a node to test, messages of a bag."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

NODE = os.environ.get("SLAMICP_NODE", "slamicp_node")
PROGRAM = os.environ.get("SLAMICP", "slamicp")
PORT = "11311"


def data_dir():
    """Where the real data lie, or None."""
    name = os.environ.get("SLAMICP_DATA_DIR") or os.environ.get("SLAMICP_DEFAULT_DATA_DIR")
    return pathlib.Path(name) if name and os.path.isdir(name) else None


def enter_own_network():
    """ROS listens on every address whatever it is told: it gets a network that has none but its own."""
    if os.environ.get("SLAMICP_OWN_NETWORK") == "1":
        return
    os.environ.update(SLAMICP_OWN_NETWORK="1", ROS_MASTER_URI=f"http://127.0.0.1:{PORT}", ROS_IP="127.0.0.1",
                      ROS_PYTHON_VERSION="3", ROS_HOME=tempfile.mkdtemp(prefix="slamicp_ros_home_"),
                      PATH="/usr/sbin:/usr/bin:/sbin:/bin")
    os.environ.pop("ROS_HOSTNAME", None)
    words = ["unshare", "--net"] + ([] if os.geteuid() == 0 else ["--map-root-user"])
    os.execvp(words[0], [*words, "sh", "-c", 'ip link set lo up && exec "$@"', "_", sys.executable, "-B", *sys.argv])


def start_master():
    import rosgraph
    process = subprocess.Popen(["roscore", "-p", PORT], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    for _ in range(1200):
        try:
            rosgraph.Master("/test").lookupNode("/rosout")
            return process
        except Exception:  # not yet
            time.sleep(0.05)
    raise RuntimeError("roscore does not come up")


def stop(process):
    process.send_signal(signal.SIGINT)  # a node then says good-bye to the master
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def wait_for(what, seconds=60.0, every=0.01):
    """True as soon as `what` is."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if what():
            return True
        time.sleep(every)
    return bool(what())


def start_node(*words, name="slamicp", **parameters):
    """The node, with private parameters by their names."""
    def told(value):
        return str(value).lower() if isinstance(value, bool) else str(value)
    return subprocess.Popen([NODE, *words, f"__name:={name}", *(f"_{key}:={told(value)}"
                                                                for key, value in parameters.items())])


class RosTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *words, name=None, **parameters):
        # The master keeps private parameters: each test has a name of its own.
        process = start_node(*words, name=name or self.id().rsplit(".", 1)[1], **parameters)
        self.addCleanup(stop, process)
        return process

    def slamicp(self, *words):
        result = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True,
                                timeout=300)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout
