# SPDX-License-Identifier: BSD-3-Clause
"""Scan matching leaves the way that wheels tell as it is where the scans may not tell it."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
BINARIES = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"])


class CorridorLengthTest(unittest.TestCase):
    def run_tool(self, *words):
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def rmse_m(self, seed, *flags):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.run_tool(ROOT / "experiments" / "stress" / "random_world.py", "--kind=corridors",
                          f"--seed={seed}", f"--output_dir={folder}")
            self.run_tool(BINARIES / "simulate", f"--world={folder / 'world.yaml'}",
                          f"--flagfile={folder / 'simulate.flags'}", *flags,
                          f"--output_dir={folder}")
            self.run_tool(BINARIES / "gmapping_spa", f"--log={folder / 'log.clf'}",
                          f"--output_dir={folder / 'map'}")
            scores = json.loads(self.run_tool(
                BINARIES / "evaluate_trajectory", f"--truth={folder / 'truth.tum'}",
                f"--trajectory={folder / 'map' / 'trajectory.tum'}"))
        return scores["ate"]["translation_m"]["rmse"]

    def test_exact_wheels_keep_a_turned_corridor_of_shut_doors_in_reverse(self):
        self.assertLess(self.rmse_m(6, "--wheels=exact"), 0.06)  # of 114 m; it was 0.72

    def test_wheels_off_by_a_few_percent_keep_a_corridor_of_noisy_ranges(self):
        self.assertLess(self.rmse_m(39), 0.4)  # of 151 m; it was 1.58


if __name__ == "__main__":
    unittest.main()
