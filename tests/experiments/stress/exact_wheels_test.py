# SPDX-License-Identifier: BSD-3-Clause
"""Scan matching leaves exact wheels as they are where the scans may not tell the way."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
BINARIES = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"])


class ExactWheelsTest(unittest.TestCase):
    def run_tool(self, *words):
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_turned_corridor_of_shut_doors_in_reverse_keeps_its_length(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.run_tool(ROOT / "experiments" / "stress" / "random_world.py", "--kind=corridors",
                          "--seed=6", f"--output_dir={folder}")
            self.run_tool(BINARIES / "simulate", f"--world={folder / 'world.yaml'}",
                          f"--flagfile={folder / 'simulate.flags'}", "--wheels=exact",
                          f"--output_dir={folder}")
            self.run_tool(BINARIES / "gmapping_spa", f"--log={folder / 'log.clf'}",
                          f"--output_dir={folder / 'map'}")
            scores = json.loads(self.run_tool(
                BINARIES / "evaluate_trajectory", f"--truth={folder / 'truth.tum'}",
                f"--trajectory={folder / 'map' / 'trajectory.tum'}"))
        self.assertLess(scores["ate"]["translation_m"]["rmse"], 0.06)  # of 114 m; it was 0.72


if __name__ == "__main__":
    unittest.main()
