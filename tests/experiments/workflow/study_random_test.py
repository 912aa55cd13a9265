# SPDX-License-Identifier: BSD-3-Clause
"""Studies of random buildings: each seed has one of its own, and what is wrong is named."""
import pathlib
import unittest

import workflow_test_case
from workflow_test_case import BINARIES

import log_tools
from study import StudyError, load_study

STUDY = """
    title: A study
    datasets:
      hall: {random: hall}
      yard: {random: yard}
    seeds: 1-2
    metrics: [ate_rmse_m]
"""


class StudyRandomTest(workflow_test_case.WorkflowTestCase):
    def load(self, text=STUDY):
        return load_study(self.write("study.yaml", text), BINARIES, self.folder)

    def complaint(self, new):
        """What is said about another first dataset."""
        with self.assertRaises(StudyError) as caught:
            self.load(STUDY.replace("{random: hall}", new))
        return str(caught.exception).replace(str(self.folder) + "/", "")

    def test_the_seed_makes_the_building(self):
        runs = self.load().runs
        self.assertEqual(len({run.log_id for run in runs}), 4)
        self.assertEqual([run.log_id for run in runs], [run.log_id for run in self.load().runs])
        self.assertEqual((runs[1].log_tool, runs[1].log_argv, runs[1].log_file),
                         ("random_world", ["--kind=hall", "--seed=2"], None))

    def test_the_simulator_beside_gmapping_spa_drives(self):
        words = log_tools.command("random_world", ["--seed=2"], pathlib.Path("/bin_of_study"))
        self.assertTrue(words[0].endswith("experiments/stress/random_world.py"))
        self.assertEqual(words[1:], ["--seed=2", "--simulate=/bin_of_study/simulate"])

    def test_another_simulator_is_another_version(self):
        version = log_tools.version("random_world", BINARIES)
        self.assertRegex(version, r"random_world.py [0-9a-f]{16}, simulate .*build [0-9a-f]{16}")

    def test_unknown_kinds_are_named_with_line_and_proposal(self):
        self.assertEqual(self.complaint("{random: hal}"),
                         "study.yaml:3: random: unknown kind of building 'hal'; did you mean 'hall'?")

    def test_a_random_building_is_nothing_else(self):
        self.assertIn("study.yaml:3: hall: expected one of 'carmen: NAME'",
                      self.complaint("{random: hall, world: room.yaml}"))
        self.assertIn("study.yaml:3: stress: 'stress' is not for random buildings",
                      self.complaint("{random: hall, stress: drop}"))


if __name__ == "__main__":
    unittest.main()
