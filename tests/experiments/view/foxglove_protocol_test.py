#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run as Foxglove sees it, by Foxglove's own client. Skipped, visibly, without Node.js or the packages
@foxglove/ws-protocol and ws; where they are, GMAPPING_SPA_NODE_MODULES says (npm install
@foxglove/ws-protocol ws)."""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import unittest

import view_fixture

MODULES = pathlib.Path(os.environ.get("GMAPPING_SPA_NODE_MODULES", "node_modules"))
CLIENT = pathlib.Path(__file__).with_name("foxglove_client.js")


@unittest.skipUnless(shutil.which("node") and (MODULES / "@foxglove" / "ws-protocol").exists(),
                     "Node.js or @foxglove/ws-protocol is not there; set GMAPPING_SPA_NODE_MODULES")
class FoxgloveProtocolTest(view_fixture.ViewTestCase):
    def test_client_of_foxglove_gets_every_topic(self):
        program = self.start()
        done = subprocess.run(["node", CLIENT, program.url.replace("http:", "ws:")], text=True,
                              capture_output=True, timeout=300,
                              env={**os.environ, "NODE_PATH": str(MODULES.resolve())})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(program.wait(), 0)
        told = json.loads(done.stdout)
        self.assertEqual(told["info"]["name"], "gmapping_spa: log.clf")
        self.assertEqual(told["statuses"], [])
        channels = told["channels"]
        self.assertEqual({topic: channel["schemaName"] for topic, channel in channels.items()}, {
            "/tf": "foxglove.FrameTransforms", "/pose": "foxglove.PoseInFrame",
            "/particles": "foxglove.PosesInFrame", "/scan": "foxglove.LaserScan",
            "/map": "foxglove.Grid", "/path": "foxglove.PosesInFrame",
            "/graph": "foxglove.SceneUpdate", "/health": "foxglove.Log"})
        for topic, channel in channels.items():
            with self.subTest(topic):
                self.assertEqual((channel["encoding"], channel["schemaEncoding"]), ("json", "jsonschema"))
                self.assertGreater(channel["messages"], 0)
                # Every field that the schema has is sent, and no other.
                self.assertEqual(set(channel["last"]), set(channel["schema"]["properties"]))
        self.expect_map(channels["/map"]["last"])
        self.assertGreater(channels["/scan"]["messages"], 1)
        self.assertEqual(channels["/pose"]["last"]["frame_id"], "map")
        self.assertEqual([t["child_frame_id"] for t in channels["/tf"]["last"]["transforms"]],
                         ["base_link", "laser"])
        self.assertGreater(len(channels["/path"]["last"]["poses"]), 50)
        self.assertEqual(len(channels["/graph"]["last"]["entities"]), 3)
        self.assertEqual(int(channels["/pose"]["timestamp_ns"]) // 10 ** 9, 62)

    def expect_map(self, grid):
        cells = base64.b64decode(grid["data"])
        self.assertEqual(len(cells) % grid["column_count"], 0)
        self.assertEqual(grid["row_stride"], grid["column_count"])
        self.assertGreater(cells.count(0), 10000)
        self.assertGreater(sum(50 < cell <= 100 for cell in cells), 1000)
        self.assertEqual(grid["cell_size"], {"x": 0.05, "y": 0.05})


if __name__ == "__main__":
    unittest.main()
