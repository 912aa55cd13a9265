#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""MCAP and CDR as @mcap/core and @foxglove/rosmsg2-serialization have them: they read what convert_log
writes, and inspect_log reads what they write. Skipped, visibly, without Node.js or these packages; where
they are, GMAPPING_SPA_NODE_MODULES says (npm install @mcap/core @foxglove/rosmsg2-serialization)."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

MODULES = pathlib.Path(os.environ.get("GMAPPING_SPA_NODE_MODULES", "node_modules"))
BINARIES = pathlib.Path(os.environ.get("GMAPPING_SPA_BINARIES", "build/bin"))
SCRIPT = pathlib.Path(__file__).with_name("independent_mcap.js")
LOG = """PARAM robot_frontlaser_offset 0.25 h 0
ODOM 0.5 -0.25 0.125 0 0 0 10.5 h 0
RAWLASER1 0 -1 2 0.5 30 0.01 0 5 1 2 3 30 4 0 11.25 h 0
ODOM 1.5 -0.25 0.125 0 0 0 12.5 h 0
"""


@unittest.skipUnless(shutil.which("node") and (MODULES / "@mcap" / "core").exists(),
                     "Node.js or @mcap/core is not there; set GMAPPING_SPA_NODE_MODULES")
class IndependentMcap(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_node(self, *words: str) -> str:
        done = subprocess.run(["node", str(SCRIPT), *words], capture_output=True, text=True,
                              env={**os.environ, "NODE_PATH": str(MODULES.resolve())})
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_reads_what_convert_log_writes(self):
        log, mcap = self.folder / "log.clf", self.folder / "log.mcap"
        log.write_text(LOG)
        subprocess.run([BINARIES / "convert_log", f"--log={log}", f"--output={mcap}",
                        "--nocompress"], check=True, capture_output=True)
        messages = json.loads(self.run_node("read", str(mcap)))
        self.assertEqual([m["topic"] for m in messages], ["/odom", "/tf_static", "/scan", "/odom"])
        odometry, tf, scan = (m["message"] for m in messages[:3])
        self.assertEqual(odometry["child_frame_id"], "base_link")
        self.assertEqual(odometry["pose"]["pose"]["position"], {"x": 0.5, "y": -0.25, "z": 0})
        self.assertEqual(len(odometry["twist"]["covariance"]), 36)
        self.assertEqual(tf["transforms"][0]["transform"]["translation"]["x"], 0.25)
        self.assertEqual(scan["header"]["stamp"], {"sec": 11, "nanosec": 250000000})
        self.assertEqual(scan["header"]["frame_id"], "laser")
        self.assertEqual(scan["range_max"], 30)
        self.assertEqual(scan["ranges"], [1, 2, 3, None, 4])  # infinity in JSON

    def test_is_read_with_and_without_chunks_and_index(self):
        for kind in ("chunks", "no_chunks", "no_channels", "no_index", "no_summary"):
            with self.subTest(kind):
                mcap = self.folder / f"{kind}.mcap"
                self.run_node("write", str(mcap), kind)
                done = subprocess.run([BINARIES / "inspect_log", f"--log={mcap}", "--json"],
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                report = json.loads(done.stdout)
                self.assertEqual(report["scans"], 300)
                self.assertEqual(report["odometry"]["scans"], 300)
                self.assertEqual(report["records"]["malformed_records"], 0)
                self.assertEqual(report["records"]["unclosed_bag"], 0)
                self.assertEqual([t["messages"] for t in report["bag"]["topics"]], [300, 300])
                self.assertAlmostEqual(report["odometry"]["path_m"], 299 * 0.125, 5)


if __name__ == "__main__":
    unittest.main()
