# SPDX-License-Identifier: BSD-3-Clause
"""A whole study of stressed logs: each run has its own log, and is scored by its relations."""
import json
import subprocess
import sys
import unittest

import numpy as np
import workflow_test_case
from workflow_test_case import BINARIES, ROOT

sys.path.append(str(ROOT / "experiments" / "stress"))

import poses
import relations

STUDY = """
    title: A stressed room
    datasets:
      room: {carmen: room, stress: [none, reverse, gaps]}
    seeds: 1-2
    flags: {particles: 1}
    metrics: [relation_error_m]
"""


class RunStressStudyTest(workflow_test_case.WorkflowTestCase):
    def setUp(self):
        super().setUp()
        subprocess.run([BINARIES / "simulate", f"--world={self.folder / 'room.yaml'}",
                        f"--path={self.folder / 'room.path.yaml'}", "--scan_rate=5",
                        f"--output_dir={self.folder / 'simulated'}"], check=True,
                       capture_output=True)
        for folder in ("carmen", "relations"):
            (self.folder / folder).mkdir()
        (self.folder / "simulated" / "log.clf").rename(self.folder / "carmen" / "room.clf")
        self.write_relations()

    def write_relations(self):
        """Between scans a second apart."""
        rows = np.loadtxt(self.folder / "simulated" / "truth.tum", comments="#")[::5]
        world_T_robot = np.stack(
            [rows[:, 1], rows[:, 2], 2 * np.arctan2(rows[:, 6], rows[:, 7])], axis=-1)
        relations.write([
            relations.Relation(relations.key(a), relations.key(b), i_T_j) for a, b, i_T_j in
            zip(rows[:-1, 0], rows[1:, 0], poses.steps_of(world_T_robot))],
            self.folder / "relations" / "room.relations")

    def test_runs_are_scored_by_the_relations_of_their_own_log(self):
        study = self.write("study.yaml", STUDY)
        self.check_study(study, "--until=scores")
        work = self.folder / "work"
        plan = json.loads((work / "plan.json").read_text())
        scans = {}
        for run_id, run in plan["runs"].items():
            scores = json.loads((work / "scores" / f"{run_id}.json").read_text())
            self.assertLess(scores["relation_error_m"], 0.1, run["label"])
            self.assertIsNone(scores["ate_rmse_m"])
            scans.setdefault(run["label"].split(",")[0], []).append(scores["scans"])
        self.assertEqual(len(set(scans["room none"] + scans["room reverse"])), 1)
        self.assertLess(max(scans["room gaps"]), scans["room none"][0] - 20)
        self.assertEqual(len(plan["logs"]), 4)
        for log in plan["logs"]:
            outcome = json.loads((work / "logs" / log / "outcome.json").read_text())
            self.assertEqual(outcome["exit_status"], 0)
            self.assertIn("stress_log.py --log=$DATA/carmen/room.clf", outcome["command"])
            self.assertTrue(outcome["version"].startswith("stress_log.py "))
        # A second call has nothing to do, and nothing to warn of.
        again = self.check_study(study, "--until=scores").stdout
        self.assertNotIn("warning", again)
        self.assertIn("6 of them done", again)


if __name__ == "__main__":
    unittest.main()
