# SPDX-License-Identifier: BSD-3-Clause
"""A whole study of a random building: it is made, driven, mapped and scored by its exact truth."""
import json
import unittest

import workflow_test_case

STUDY = """
    title: A random office
    datasets:
      office: {random: office}
    seeds: [1]
    variants: {both: {}, alone: {odometry: lidar_only}}
    metrics: [ate_rmse_m]
"""


class RunRandomStudyTest(workflow_test_case.WorkflowTestCase):
    def test_runs_of_a_seed_share_a_building_and_are_scored_by_its_truth(self):
        study = self.write("study.yaml", STUDY)
        self.check_study(study, "--until=scores")
        work = self.folder / "work"
        plan = json.loads((work / "plan.json").read_text())
        [log] = plan["logs"]
        outcome = json.loads((work / "logs" / log / "outcome.json").read_text())
        self.assertEqual((outcome["exit_status"], outcome["error"]), (0, ""))
        self.assertIn("experiments/stress/random_world.py --kind=office --seed=1", outcome["command"])
        self.assertEqual(len(plan["runs"]), 2)
        for run_id in plan["runs"]:
            scores = json.loads((work / "scores" / f"{run_id}.json").read_text())
            self.assertLess(scores["ate_rmse_m"], 0.2)
        again = self.check_study(study, "--until=scores").stdout
        self.assertNotIn("warning", again)
        self.assertIn("2 of them done", again)


if __name__ == "__main__":
    unittest.main()
