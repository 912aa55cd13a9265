# SPDX-License-Identifier: BSD-3-Clause
"""The node under a real roscore, started by its launch file: a part of a bag is played to it, and what it
makes of it is what gmapping_spa makes of the same bag. Then another node is localized in that map."""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import xmlrpc.client

BINARIES = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"])
DEFAULT_DATA = pathlib.Path(__file__).resolve().parents[4] / "shared/data"
DATA = pathlib.Path(os.environ.get("GMAPPING_SPA_DATA", DEFAULT_DATA))
BAG = DATA / "rosbag/aces.orig.bag"
PLAYER = "/usr/lib/rosbag/play"
SECONDS = 150  # of the bag
RATE = 5  # times the speed of the robot
NODE = "/slam_gmapping"
# Messages of two topics come in another order than they were recorded in: of as many seconds of the bag as
# a busy machine keeps one of them waiting, times RATE.
FLAGS = ["--reorder_window_s=10", "--base_frame=base_link", "--odom_frame=odom"]


def missing():
    if not BAG.is_file():
        return f"{BAG} is not there"
    try:
        import nav_msgs.srv, rosbag, rospy, std_srvs.srv, tf2_msgs.msg, visualization_msgs.msg  # noqa: F401
    except ImportError as error:
        return f"install_packages.sh ros: {error}"
    return "" if os.path.exists(PLAYER) else f"{PLAYER} is not there"


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def write_part(path):
    import rosbag

    scans = 0
    with rosbag.Bag(str(BAG)) as whole, rosbag.Bag(path, "w") as part:
        begin = whole.get_start_time()
        for topic, message, stamp in whole.read_messages(raw=True):
            if stamp.to_sec() > begin + SECONDS:
                break
            if topic != "/odom":  # which says what /tf says
                part.write(topic, message, stamp, raw=True)
            scans += topic == "/scan"
    return scans


@contextlib.contextmanager
def running(words, log):
    """A process, which is stopped at the end with all that it has started."""
    with open(log, "w") as out:
        process = subprocess.Popen(words, stdout=out, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            yield process
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGINT)
                try:
                    process.wait(timeout=20)
                except subprocess.TimeoutExpired:
                    os.killpg(process.pid, signal.SIGKILL)
                    process.wait()


def wait_until(is_so, seconds, what):
    end = time.monotonic() + seconds
    while not is_so():
        if time.monotonic() > end:
            raise AssertionError(f"after {seconds} s: {what}")
        time.sleep(0.05)


def write_map(grid, folder):
    """As map_saver writes it."""
    import numpy

    folder.mkdir()
    cells = numpy.array(grid.data, numpy.int8).reshape(grid.info.height, grid.info.width)[::-1]
    pixels = numpy.select([cells == 100, cells == 0], [0, 254], 205).astype(numpy.uint8)
    header = f"P5\n{grid.info.width} {grid.info.height}\n255\n".encode()
    (folder / "map.pgm").write_bytes(header + pixels.tobytes())
    origin = grid.info.origin.position
    (folder / "map.yaml").write_text(
        f"image: map.pgm\nresolution: {grid.info.resolution:.6f}\norigin: [{origin.x}, {origin.y}, 0.0]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
    )


@unittest.skipIf(missing(), missing())
class Ros1NodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.scans = write_part(str(cls.folder / "part.bag"))
        for name, flags in (("offline", []), ("driving", ["--nofinal_optimization"])):
            cls.run_offline(name, *flags)
        port = free_port()
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1",
                          ROS_LOG_DIR=str(cls.folder / "log"))
        cls.enterClassContext(running(["roscore", "-p", str(port)], cls.folder / "roscore.txt"))
        cls.play()
        cls.localize()
        import rospy

        rospy.signal_shutdown("the test is at its end")

    @classmethod
    def run_offline(cls, name, *flags):
        words = [f"--log={cls.folder}/part.bag", f"--output_dir={cls.folder}/{name}", *FLAGS, *flags]
        subprocess.run([BINARIES / "gmapping_spa", *words], check=True, capture_output=True)

    @classmethod
    def play(cls):
        import rosgraph
        import rospy

        master = rosgraph.Master("/test")
        wait_until(master.is_online, 60, "no roscore")
        master.setParam("/use_sim_time", True)
        master.setParam(f"{NODE}/xmin", -10.0)
        # No signals: unittest has its own. The clock is that of the bag.
        rospy.init_node("test", disable_signals=True)
        cls.listen()
        with cls.node("online", "map_update_interval:=1.0", f"save_session:={cls.folder}/saved"):
            cls.take_what_it_offers()
        cls.log = (cls.folder / "online.txt").read_text()
        cls.mapped_transforms = list(cls.transforms)

    @classmethod
    def localize(cls):
        cls.transforms.clear()
        with cls.node("localized", f"map_session:={cls.folder}/saved", "localize:=true"):
            pass
        cls.run_offline("localized_offline", f"--map_session={cls.folder}/saved", "--localize")

    @classmethod
    @contextlib.contextmanager
    def node(cls, name, *arguments):
        """One that has been given the whole bag, and after it has written its results."""
        import rosgraph

        launch = pathlib.Path(os.environ["ROS_PACKAGE_PATH"].split(":")[0]) / "gmapping_spa/slam.launch"
        cls.counts.clear()
        with running(["roslaunch", str(launch), f"output_dir:={cls.folder}/{name}", *arguments,
                      "flags:=" + " ".join(FLAGS)], cls.folder / f"{name}.txt"):
            wait_until(lambda: "used" in cls.counts, 60, "no diagnostics of the node")
            subprocess.run([PLAYER, "--clock", "--queue=0", f"--rate={RATE}", "--delay=1", "--quiet",
                            f"{cls.folder}/part.bag"], check=True, timeout=120, stdout=subprocess.DEVNULL)
            wait_until(lambda: cls.counts["received"] == cls.scans and cls.counts["waiting"] == 0, 60,
                       f"of {cls.scans} scans the node has {cls.counts}")
            yield
            # A signal would make it leave out the final optimization.
            uri = rosgraph.Master("/test").lookupNode(NODE)
            xmlrpc.client.ServerProxy(uri).shutdown("/test", "the bag is at its end")
            wait_until((cls.folder / name / "run.json").is_file, 60, "no results")

    @classmethod
    def listen(cls):
        import diagnostic_msgs.msg
        import rospy

        cls.counts = {}
        cls.localizations = []  # what diagnostics say of it

        def on_diagnostics(message):
            for status in message.status:
                if status.name == f"{NODE}: scans":
                    cls.counts.update({pair.key: int(pair.value) for pair in status.values})
                elif status.name == f"{NODE}: localization":
                    cls.localizations.append(status)

        rospy.Subscriber("/diagnostics", diagnostic_msgs.msg.DiagnosticArray, on_diagnostics)
        cls.transforms = []

        def on_tf(message):
            cls.transforms += [t for t in message.transforms if t.child_frame_id == "odom"]

        import tf2_msgs.msg

        rospy.Subscriber("/tf", tf2_msgs.msg.TFMessage, on_tf)

    @classmethod
    def take_what_it_offers(cls):
        import nav_msgs.msg
        import nav_msgs.srv
        import rospy
        import std_msgs.msg
        import std_srvs.srv
        import visualization_msgs.msg

        def latched(topic, kind):
            return rospy.wait_for_message(topic, kind, timeout=None)

        cls.dynamic_map = rospy.ServiceProxy("/dynamic_map", nav_msgs.srv.GetMap)().map
        cls.saved = rospy.ServiceProxy(f"{NODE}/save_session", std_srvs.srv.Trigger)()
        shutil.copy(cls.folder / "saved", cls.folder / "saved_while_it_drives")
        cls.map = latched("/map", nav_msgs.msg.OccupancyGrid)
        cls.metadata = latched("/map_metadata", nav_msgs.msg.MapMetaData)
        cls.entropy = latched(f"{NODE}/entropy", std_msgs.msg.Float64)
        cls.graph = latched(f"{NODE}/graph", visualization_msgs.msg.MarkerArray)

    def test_it_says_nothing_that_is_wrong(self):
        for line in self.log.splitlines():
            self.assertNotIn("ERROR", line)

    def test_it_says_what_it_does_not_use(self):
        self.assertIn("~xmin is not used: maps grow with what is seen", self.log)

    def test_no_scan_is_lost(self):
        record = json.loads((self.folder / "online/run.json").read_text())
        scans = record["input"]["live_scans"]
        self.assertEqual(scans["used"], self.scans)
        for name in ("lost", "refused", "throttled", "waiting", "after_time_jump", "transforms_refused"):
            self.assertEqual(scans[name], 0, name)
        self.assertIn(f'"used":{self.scans}', self.log)
        self.assertNotIn("not all scans", self.log)

    def test_results_are_those_of_the_bag(self):
        for name in ("trajectory.tum", "map.pgm", "map.yaml", "graph.g2o"):
            self.assertEqual((self.folder / "online" / name).read_bytes(),
                             (self.folder / "offline" / name).read_bytes(), name)

    def test_sessions_go_on_with_the_bag(self):
        self.assertTrue(self.saved.success, self.saved.message)
        for name in ("saved_while_it_drives", "saved"):
            self.run_offline(f"after_{name}", f"--resume={self.folder}/{name}")
            self.assertEqual((self.folder / f"after_{name}/trajectory.tum").read_bytes(),
                             (self.folder / "offline/trajectory.tum").read_bytes(), name)

    def test_the_map_while_it_drives_is_that_of_the_bag(self):
        write_map(self.dynamic_map, self.folder / "live")
        words = [f"--map={self.folder}/live/map.yaml", f"--truth={self.folder}/driving/map.yaml",
                 f"--truth_trajectory={self.folder}/driving/trajectory.tum", "--align=none"]
        errors = json.loads(subprocess.run([BINARIES / "evaluate_map", *words], check=True,
                                           capture_output=True).stdout)
        # The map of the bag with itself has 0.99; some scans come after the last one that was published.
        self.assertGreater(errors["iou"], 0.9)

    def test_the_service_has_the_map_of_the_topic(self):
        self.assertEqual(self.map.data, self.dynamic_map.data)
        self.assertEqual(self.map.header.frame_id, "map")
        self.assertEqual(self.metadata, self.map.info)

    def test_the_odometry_has_a_place_in_the_map(self):
        self.assertGreater(len(self.mapped_transforms), 10)
        last = self.mapped_transforms[-1]
        self.assertEqual(last.header.frame_id, "map")
        # The odometry of this log begins with a heading of -90 degrees.
        self.assertAlmostEqual(last.transform.rotation.z, 0.5**0.5, delta=0.1)

    def test_robot_is_localized_in_the_map_of_before_as_with_the_bag(self):
        for name in ("trajectory.tum", "map.pgm", "localization.csv"):
            self.assertEqual((self.folder / "localized" / name).read_bytes(),
                             (self.folder / "localized_offline" / name).read_bytes(), name)

    def test_nothing_is_said_of_its_pose_before_it_is_found(self):
        record = json.loads((self.folder / "localized/run.json").read_text())
        found_s = record["session"]["found"][0]["stamp_s"]
        self.assertGreater(len(self.transforms), 10)
        # The clock may be ahead of the scan that is used.
        self.assertGreater(min(t.header.stamp.to_sec() for t in self.transforms), found_s)
        self.assertEqual((self.localizations[0].level, self.localizations[-1].level), (1, 0))

    def test_the_pose_graph_is_shown(self):
        markers = {marker.ns: marker for marker in self.graph.markers}
        self.assertEqual(set(markers), {"path", "nodes", "loop_closures"})
        self.assertGreater(len(markers["nodes"].points), 10)
        self.assertGreaterEqual(self.entropy.data, 0.0)


if __name__ == "__main__":
    unittest.main()
