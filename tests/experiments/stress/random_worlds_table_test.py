# SPDX-License-Identifier: BSD-3-Clause
"""The table of random buildings: who failed, who of them said nothing, who cried wolf."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
STRESS = ROOT / "experiments" / "stress"
sys.path[:0] = [str(STRESS), str(ROOT / "tests" / "experiments" / "workflow")]

import random_worlds_table
import report_fixture
from random_worlds_table import Verdict
from report.table import text

STUDY = """
title: Random buildings
datasets:
  hall: {random: hall}
seeds: 1-4
variants:
  both: {}
  alone: {odometry: lidar_only}
metrics: [ate_rmse_m]
quick: {seeds: 1-2}
"""
ODOMETRY = "<flag><name>odometry</name><type>string</type></flag></group>"
GOOD = [(0.01, [])] * 4
WAY_M = 100.0  # 0.2 m are allowed


class RandomResults(report_fixture.Results):
    """Errors, and kinds of findings, by variant and seed; None: the run ended with an error."""

    def __init__(self, folder, found):
        self.found = found
        words = report_fixture.HELP.replace("</group>", ODOMETRY)
        with mock.patch.object(report_fixture, "HELP", words):
            super().__init__(folder, STUDY)

    def write(self, run):
        error_m, findings = self.found[run.configuration.variant][run.seed - 1]
        folder = self.work / "runs" / run.id
        folder.mkdir(parents=True, exist_ok=True)
        report_fixture.write_json(folder / "outcome.json", {"exit_status": int(findings is None)})
        report_fixture.write_json(folder / "run.json",
                                  {"health": dict.fromkeys(findings or [], {"count": 1})})
        self.write_scores(run, {"ate_rmse_m": error_m})
        log = self.work / "logs" / run.log_id
        log.mkdir(parents=True, exist_ok=True)
        (log / "truth.tum").write_text("# stamp x y\n0 0 0 0 0 0 0 1\n"
                                       f"1 {0.6 * WAY_M} {0.8 * WAY_M} 0 0 0 0 1\n")


class RandomWorldsTableTest(unittest.TestCase):
    def rows(self, both=None):
        """As text by variant, without building and setting."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.results = RandomResults(folder.name, {"both": both or GOOD, "alone": GOOD})
        table = random_worlds_table.random_worlds(
            report_fixture.measure(self.results.study, self.results.work), self.results.work)
        self.assertEqual([row[0] for row in table.rows], ["hall", "hall"])
        return {row[1]: [text(cell) for cell in row[2:]] for row in table.rows}

    def test_good_runs_have_not_failed(self):
        self.assertEqual(self.rows()["alone"],
                         ["4", "0.010 (0.010)", "0", "0", "0 of 4", "none"])

    def test_who_failed_without_a_word_was_silent(self):
        rows = self.rows([(0.21, []), (0.3, ["odometry_contradicted"]), (0.4, ["lost"]), (0.19, [])])
        self.assertEqual(rows["both"],
                         ["4", "0.255 (0.400)", "3", "**2**", "0 of 1", "**1**, **2**, 3"])

    def test_who_says_something_for_nothing_is_a_false_alarm(self):
        rows = self.rows([(0.01, ["lost"]), (0.01, ["laser_pose_used"]), (0.01, []), (0.01, [])])
        self.assertEqual(rows["both"][2:], ["0", "0", "1 of 4", "none"])

    def test_an_error_is_a_failure_that_says_so(self):
        rows = self.rows([(None, None)] * 4)
        self.assertEqual(rows["both"], ["4", "–", "4", "0", "0 of 0", "1, 2, 3, 4"])

    def test_the_bound_is_a_part_of_the_way_and_never_below_the_least(self):
        self.assertEqual(random_worlds_table.bound_m(WAY_M), 0.2)
        self.assertEqual(random_worlds_table.bound_m(1), 0.05)
        self.assertTrue(Verdict(1.0, failed=True, said=False).silent())
        self.assertFalse(Verdict(0.0, failed=False, said=False).silent())

    def test_all_findings_that_count_are_explained(self):
        keys = set(re.findall(r"`(\w+)`", (ROOT / "experiments" / "docs" / "faq.md").read_text()))
        self.assertLessEqual(random_worlds_table.SAYING, keys)

    def test_the_command_writes_the_table(self):
        self.rows()
        done = subprocess.run(
            [STRESS / "random_worlds_table.py", self.results.study_file,
             f"--work_dir={self.results.work}", f"--bin={self.results.binaries}",
             f"--data={self.results.folder}"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        made = pathlib.Path(done.stdout.split()[-1]).read_text()
        self.assertIn("| hall | both | 4 | 0.010 (0.010) | 0 | 0 | 0 of 4 | none |", made)


if __name__ == "__main__":
    unittest.main()
