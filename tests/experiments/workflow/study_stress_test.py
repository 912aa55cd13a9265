# SPDX-License-Identifier: BSD-3-Clause
"""Studies of stressed logs: each seed has a log of its own, and what is wrong is named."""
import unittest

import workflow_test_case
from workflow_test_case import BINARIES

from study import StudyError, load_study

STUDY = """
    title: A study
    datasets:
      hall: {carmen: hall, stress: [none, late, drop]}
      attic: {carmen: hall, stress: late, size: 2}
    seeds: 1-2
    metrics: [relation_error_m]
    quick:
      datasets:
        attic: null
        hall: {stress: [drop]}
"""


class StudyStressTest(workflow_test_case.WorkflowTestCase):
    def setUp(self):
        super().setUp()
        for folder in ("carmen", "relations"):
            (self.folder / folder).mkdir()
        self.write("carmen/hall.clf.gz", "not read here")
        self.write("relations/hall.relations.gz", "neither")

    def load(self, text=STUDY, quick=False):
        return load_study(self.write("study.yaml", text), BINARIES, self.folder, quick)

    def complaint(self, old, new):
        self.assertIn(old, STUDY)
        with self.assertRaises(StudyError) as caught:
            self.load(STUDY.replace(old, new))
        return str(caught.exception).replace(str(self.folder) + "/", "")

    def test_a_list_is_a_dataset_of_each_kind(self):
        study = self.load()
        self.assertEqual([config.dataset for config in study.configurations],
                         ["hall none", "hall late", "hall drop", "attic"])
        self.assertEqual([config.dataset for config in self.load(quick=True).configurations],
                         ["hall drop"])

    def test_the_seed_makes_the_log(self):
        stressed = [run for run in self.load().runs if run.configuration.dataset != "hall none"]
        self.assertEqual(len({run.log_id for run in stressed}), len(stressed))
        folder = self.folder.resolve()
        self.assertEqual(stressed[-1].log_argv, [
            f"--log={folder}/carmen/hall.clf.gz",
            f"--relations={self.folder}/relations/hall.relations.gz", "--stress=late", "--size=2",
            "--seed=2"])
        self.assertEqual((stressed[-1].log_tool, stressed[-1].log_file, stressed[-1].relations),
                         ("stress_log", None, None))

    def test_unstressed_is_the_recorded_log(self):
        run = self.load().runs[0]
        plain = self.load(STUDY.replace("stress: late, size: 2", "")
                          .replace("carmen: hall, }", "carmen: hall}"))
        self.assertEqual((run.log_id, run.log_tool), (None, None))
        self.assertEqual(run.relations.name, "hall.relations.gz")
        self.assertIn(run.id, {other.id for other in plain.runs
                               if other.configuration.dataset == "attic"})

    def test_what_the_log_is_decides_its_id(self):
        before = {run.log_id for run in self.load().runs}
        self.assertEqual(before, {run.log_id for run in self.load().runs})
        size = {run.log_id for run in self.load(STUDY.replace("size: 2", "size: 3")).runs}
        self.assertEqual(len(before - size), 2)

    def test_unknown_kinds_are_named_with_line_and_proposal(self):
        self.assertEqual(self.complaint("late, drop", "late, dorp"),
                         "study.yaml:3: stress: unknown stress 'dorp'; did you mean 'drop'?")
        self.assertIn("study.yaml:4: stress: unknown stress 'lat'",
                      self.complaint("stress: late", "stress: lat"))

    def test_stress_and_size_must_make_sense(self):
        self.assertIn("study.yaml:4: size: expected a number above 0, found '-1'",
                      self.complaint("size: 2", "size: -1"))
        self.assertIn("study.yaml:4: size: expected a 'stress' that it scales",
                      self.complaint("stress: late, size: 2", "size: 2"))
        self.assertIn("study.yaml:4: stress: 'stress' is for recorded datasets",
                      self.complaint("carmen: hall, stress: late, size: 2",
                                     "world: room.yaml, stress: late"))
        for kinds in ("[]", "[late, late]"):
            self.assertIn("study.yaml:3: stress: expected different kinds",
                          self.complaint("[none, late, drop]", kinds))

    def test_two_datasets_of_one_name_are_named(self):
        self.assertIn("study.yaml:4: hall late: the dataset 'hall late' is there twice",
                      self.complaint("attic:", "hall late:"))

    def test_an_axis_over_the_simulator_is_for_simulated_datasets(self):
        text = STUDY.replace("seeds: 1-2", "seeds: 1-2\n    axes: {simulate.scan_rate: [1, 2]}")
        with self.assertRaisesRegex(StudyError, "is for datasets with a 'world'; 'hall none' has none"):
            self.load(text)


if __name__ == "__main__":
    unittest.main()
