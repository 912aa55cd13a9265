# SPDX-License-Identifier: BSD-3-Clause
"""Threads of Python go on during long calls, and Ctrl-C ends them."""

import signal
import subprocess
import sys
import textwrap
import threading
import time
import unittest

import numpy as np
import room

import gmapping_spa as gs


def long_chain(nodes):
    """A graph whose certificate takes a second or so."""
    generator = np.random.default_rng(1)
    chain = np.zeros(nodes, gs.NODE_DTYPE)
    chain["id"] = np.arange(nodes)
    chain["world_T_node"] = np.cumsum(generator.normal(0, 1, (nodes, 3)), axis=0)
    edges = np.zeros(3 * nodes, gs.EDGE_DTYPE)
    edges["i"] = generator.integers(0, nodes, 3 * nodes)
    edges["j"] = (edges["i"] + generator.integers(1, nodes, 3 * nodes)) % nodes
    edges["i"][: nodes - 1], edges["j"][: nodes - 1] = np.arange(nodes - 1), np.arange(1, nodes)
    edges["i_T_j"] = generator.normal(0, 1, (3 * nodes, 3))
    edges["information"] = np.eye(3)
    return gs.PoseGraph(chain, edges)


class GilTest(unittest.TestCase):
    def ticks_during(self, call):
        """How often another thread got to work during the call, and the longest wait, s."""
        stamps, done = [], threading.Event()

        def tick():
            while not done.is_set():
                stamps.append(time.monotonic())
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        begin = time.monotonic()
        call()
        end = time.monotonic()
        done.set()
        thread.join()
        return sum(begin < stamp < end for stamp in stamps), end - begin

    def test_another_thread_goes_on_while_slam_finishes(self):
        slam = gs.Slam()
        for scan in room.run().scans:
            slam.add_scan(scan)
        ticks, duration_s = self.ticks_during(slam.finish)
        self.assertGreater(ticks, 5, f"in {duration_s} s")

    def test_another_thread_goes_on_while_a_graph_is_optimized(self):
        graph = long_chain(1000)
        ticks, duration_s = self.ticks_during(lambda: gs.optimize(graph, loss="none"))
        self.assertGreater(ticks, 5, f"in {duration_s} s")

    def test_a_slam_takes_one_call_at_a_time(self):
        slam, refused = gs.Slam(), []
        slam.add_scan(room.run().scans[0])

        class Nosy:  # it asks from the thread of the graph, while finish() waits for it
            def optimize(self, nodes, edges):
                try:
                    self.slam.pose
                except RuntimeError as error:
                    refused.append(str(error))
                return nodes["world_T_node"]

        nosy = Nosy()
        nosy.slam = gs.Slam(gs.SlamOptions(loss="none"), nosy)
        for scan in room.run().scans[:100]:
            nosy.slam.add_scan(scan)
        nosy.slam.finish()
        self.assertTrue(any("one call at a time" in text for text in refused))

    def test_two_slams_in_two_threads_get_the_same_as_one(self):
        results = {}

        def work(name):
            slam = gs.Slam()
            for scan in room.run().scans:
                slam.add_scan(scan)
            results[name] = slam.trajectory

        room.run()
        threads = [threading.Thread(target=work, args=(k,)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        work("alone")
        np.testing.assert_array_equal(results[0], results["alone"])
        np.testing.assert_array_equal(results[1], results["alone"])


class InterruptTest(unittest.TestCase):
    PRELUDE = """
        import sys, threading, os, signal, time
        sys.path.insert(0, {folder!r})
        import numpy as np, room, thread_test
        import gmapping_spa as gs
        def interrupt_in(seconds):
            threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT)).start()
    """

    def run_script(self, script, timeout_s=100):
        prelude = textwrap.dedent(self.PRELUDE).format(folder=__file__.rpartition("/")[0] or ".")
        return subprocess.run([sys.executable, "-c", prelude + textwrap.dedent(script)],
                              capture_output=True, text=True, timeout=timeout_s)

    def test_ends_a_plugin_at_work(self):
        done = self.run_script("""
            graph = thread_test.long_chain(4000)
            interrupt_in(0.3)
            begin = time.monotonic()
            try:
                gs.certify(graph, descend=True)
            except KeyboardInterrupt:
                print("stopped after", time.monotonic() - begin, flush=True)
                os._exit(0)
        """)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("stopped after", done.stdout)

    def test_ends_finish_and_leaves_a_slam_that_says_so(self):
        done = self.run_script("""
            class Slow:
                def optimize(self, nodes, edges):
                    time.sleep(0.5)
            slam = gs.Slam(gs.SlamOptions(loss="none", optimize_every=1000, graph_timeout_s=60), Slow())
            for scan in room.run().scans[:60]:
                slam.add_scan(scan)
            interrupt_in(0.1)
            begin = time.monotonic()
            try:
                slam.finish()
            except KeyboardInterrupt:
                print("stopped after", time.monotonic() - begin)
            try:
                slam.pose
            except RuntimeError as error:
                print(error)
        """)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess(float(done.stdout.split()[2]), 0.5)
        self.assertIn("was interrupted", done.stdout)

    def test_ends_a_back_end_in_python_and_the_simulator(self):
        done = self.run_script("""
            class Endless:
                def optimize(self, nodes, edges):
                    while True:
                        pass
            for call in (lambda: gs.optimize(room.square_graph(), Endless(), loss="none"),
                         lambda: gs.simulate(room.world(), room.TOUR * 200, beams=5000)):
                interrupt_in(0.5)
                try:
                    call()
                except KeyboardInterrupt:
                    print("stopped")
        """)
        self.assertEqual(done.stdout.split(), ["stopped"] * 2, done.stderr)

    def test_a_loop_over_scans_ends_by_the_signal(self):
        done = self.run_script("""
            slam = gs.Slam()
            interrupt_in(0.5)
            stamp_s = 0.0
            while True:
                for scan in room.run().scans:
                    stamp_s += 0.1
                    slam.add_scan(gs.LaserScan(stamp_s, scan.beams["range_m"]))
        """)
        self.assertEqual(done.returncode, -signal.SIGINT)
        self.assertIn("KeyboardInterrupt", done.stderr)

    def test_an_interpreter_that_ends_waits_for_a_back_end_at_work(self):
        done = self.run_script("""
            class Slow:
                def optimize(self, nodes, edges):
                    time.sleep(1)
                    print("optimized", flush=True)
            slam = gs.Slam(gs.SlamOptions(loss="none", optimize_every=1, graph_thread="async"), Slow())
            for scan in room.run().scans[:40]:
                slam.add_scan(scan)
        """)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("optimized", done.stdout)


if __name__ == "__main__":
    unittest.main()
