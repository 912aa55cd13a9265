# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the workflow share: a folder of their own, a tiny world, and run_study.py."""
import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
BINARIES = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"])
WORKFLOW = ROOT / "experiments" / "workflow"
sys.path.insert(0, str(WORKFLOW))

WORLD = """
    size: [12, 8]
    resolution: 0.05
    boxes:
      - [0, 0, 12, 0.3]
      - [0, 7.7, 12, 8]
      - [0, 0.3, 0.3, 7.7]
      - [11.7, 0.3, 12, 7.7]
      - [4, 3, 7, 5]
"""
PATH = """
    way_points: [[2, 1.6], [9.5, 1.6], [9.5, 6.4], [2, 6.4], [2, 1.6]]
"""


class WorkflowTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("room.yaml", WORLD)
        self.write("room.path.yaml", PATH)

    def write(self, name, text):
        file = self.folder / name
        file.write_text(textwrap.dedent(text).lstrip("\n"))
        return file

    def command(self, study, *words, work="work"):
        return ["/usr/bin/python3", WORKFLOW / "run_study.py", "-j", "2",
                f"--work_dir={self.folder / work}", f"--bin={BINARIES}",
                f"--data={self.folder}", *words, study]

    def run_study(self, study, *words, work="work"):
        return subprocess.run(self.command(study, *words, work=work), capture_output=True,
                              text=True)

    def check_study(self, study, *words, work="work"):
        done = self.run_study(study, *words, work=work)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done
