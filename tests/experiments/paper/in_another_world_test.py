# SPDX-License-Identifier: BSD-3-Clause
"""The paper's studies in a reader's world, and what reproduce.sh makes of its flags."""
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "workflow"))

import workflow_test_case
from workflow_test_case import BINARIES, ROOT

from report import checks
from study import load_study

PAPER = ROOT / "experiments" / "paper"
OBSTACLES = """
    boxes:
      - [7.5, 3, 8, 4]
    pedestrian_size: [0.2, 0.4]
    pedestrian_speed: 1
    pedestrian_way_points: [[1, 4], [2, 4]]
"""


class InAnotherWorldTest(workflow_test_case.WorkflowTestCase):
    def setUp(self):
        super().setUp()
        self.world = self.folder / "room.yaml"
        self.studies = [file for file in sorted(PAPER.glob("*.yaml")) if file.stem != "claims"]

    def move(self, *words):
        return subprocess.run(
            [sys.executable, PAPER / "in_another_world.py", *words, f"--bin={BINARIES}",
             f"--output={self.folder / 'studies'}", *self.studies], capture_output=True, text=True)

    def complaint(self, *words):
        done = self.move(*words)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr

    def moved(self, *words):
        """The studies that can run, full and quick."""
        done = self.move(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        files = [pathlib.Path(line) for line in done.stdout.splitlines()]
        return [[load_study(file, BINARIES, self.folder, quick) for file in files]
                for quick in (False, True)]

    def test_every_dataset_is_of_that_world_and_claims_still_fit(self):
        for studies in self.moved(f"--world={self.world}"):
            checks.check(studies)
            names = {study.name for study in studies}
            self.assertIn("experiment_1", names)
            self.assertNotIn("experiment_2", names)
            for study in studies:
                self.assertIn("room", study.title)
                for run in study.runs:
                    self.assertIn(f"--world={self.world}", run.log_argv)
                    self.assertIn(f"--path={self.folder / 'room.path.yaml'}", run.log_argv)

    def test_with_obstacles_all_studies_run(self):
        obstacles = self.write("obstacles.yaml", OBSTACLES)
        for studies in self.moved(f"--world={self.world}", f"--obstacles={obstacles}"):
            self.assertEqual([study.name for study in studies],
                             [file.stem for file in self.studies])
            experiment_2 = next(study for study in studies if study.name == "experiment_2")
            self.assertIn(f"--obstacles={obstacles}", experiment_2.runs[0].log_argv)

    def test_what_is_wrong_is_one_line(self):
        self.assertIn("no such file", self.complaint(f"--world={self.folder / 'no.yaml'}"))
        into_the_wall = self.write("wall.yaml", "way_points: [[2, 1.6], [5, 4]]")
        self.assertIn("(4.00, 3.00)",
                      self.complaint(f"--world={self.world}", f"--path={into_the_wall}"))
        misspelt = self.write("misspelt.yaml", "size: [12, 8]\nresolution: 0.05\nboxs: []\n")
        self.assertIn("misspelt.yaml:3", self.complaint(
            f"--world={misspelt}", f"--path={self.folder / 'room.path.yaml'}"))

    def test_reproduce_refuses_files_that_are_not_there_before_it_builds(self):
        for words, expected in ((["--world=no.yaml"], "--world=no.yaml: expected a file"),
                                (["--world", "no.yaml"], "--world=no.yaml: expected a file"),
                                (["--world"], "--world needs a value"),
                                ([f"--path={self.world}"], "need --world=FILE")):
            done = subprocess.run([PAPER / "reproduce.sh", *words], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn(expected, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
