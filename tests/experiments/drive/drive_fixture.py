# SPDX-License-Identifier: BSD-3-Clause
"""The program drive in the paper's building, and what gmapping_spa makes of what it saved."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "view"))
import view_fixture
from view_fixture import BINARIES, WORLDS

WORLD = f"--world={WORLDS / 'paper_building.yaml'}"
SHORT = f"--path={WORLDS / 'paper_building.short.path.yaml'}"
OBSTACLES = (f"--obstacles={WORLDS / 'paper_obstacles.yaml'}", "--walking_pedestrian")


class DriveTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *flags, port=0, output="out"):
        program = view_fixture.Program(WORLD, SHORT, f"--output_dir={self.folder / output}", *flags,
                                       port=port, name="drive")
        self.addCleanup(program.end)
        return program

    def run_offline(self, *flags, output="out"):
        """The folder of what gmapping_spa makes of the saved log."""
        results = self.folder / "offline"
        subprocess.run([BINARIES / "gmapping_spa", f"--log={self.folder / output / 'log.clf'}",
                        f"--output_dir={results}", *flags], check=True, capture_output=True)
        return results

    def measure(self, results, output="out"):
        """IoU and ATE in m of offline results against the saved truth."""
        truth, trajectory = self.folder / output / "truth", f"--trajectory={results / 'trajectory.tum'}"

        def errors(program, *flags):
            return json.loads(subprocess.run([BINARIES / program, trajectory, *flags], check=True,
                                             capture_output=True).stdout)

        of_map = errors("evaluate_map", f"--map={results / 'map.yaml'}", f"--truth={truth}.yaml",
                        f"--truth_trajectory={truth}.tum")
        of_trajectory = errors("evaluate_trajectory", f"--truth={truth}.tum")
        return of_map["iou"], of_trajectory["ate"]["translation_m"]["rmse"]

    def expect_same(self, one, other):
        self.assertTrue(one.read_bytes() == other.read_bytes(), f"{one} and {other} differ")
