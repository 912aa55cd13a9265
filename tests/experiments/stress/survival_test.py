# SPDX-License-Identifier: BSD-3-Clause
"""The table of survival: limits from the unstressed log, failures counted, nothing hidden."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from stress_test_case import ROOT, STRESS

sys.path.insert(0, str(ROOT / "tests" / "experiments" / "workflow"))

import report_fixture
import survival
from report.table import text

STUDY = """
title: Stressed
datasets:
  hall: {carmen: hall, stress: [none, late, thin]}
seeds: 1-3
flags: {particles: 5}
metrics: [relation_error_m]
quick: {seeds: 1-2}
"""
ERRORS_M = {"none": [0.020, 0.021, 0.030], "late": [0.026, 0.027, 0.020],
            "thin": [0.050, 0.053, 0.050]}


class HallResults(report_fixture.Results):
    def __init__(self, folder, errors_m):
        for name in ("carmen/hall.clf", "relations/hall.relations"):
            file = pathlib.Path(folder) / name
            file.parent.mkdir()
            file.write_text("not read here")
        self.errors_m = errors_m
        super().__init__(folder, STUDY)

    def write(self, run):
        error_m = self.errors_m[run.configuration.dataset.split()[1]][run.seed - 1]
        folder = self.work / "runs" / run.id
        folder.mkdir(parents=True, exist_ok=True)
        report_fixture.write_json(folder / "outcome.json", {"exit_status": int(error_m is None)})
        report_fixture.write_json(folder / "run.json", {})
        self.write_scores(run, {"relation_error_m": error_m})


class SurvivalTest(unittest.TestCase):
    def table(self, errors_m=None):
        """Rows as text: stress, hall."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.results = HallResults(folder.name, ERRORS_M | (errors_m or {}))
        table = survival.survival(report_fixture.measure(self.results.study, self.results.work))
        self.assertEqual(table.header, ["stress", "hall"])
        return {row[0]: text(row[1]) for row in table.rows}

    def test_the_limit_is_a_multiple_and_some_millimeters_at_least(self):
        self.assertAlmostEqual(survival.limit_m("late", 0.040), 0.050)
        self.assertAlmostEqual(survival.limit_m("late", 0.010), 0.015)
        self.assertAlmostEqual(survival.limit_m("thin", 0.040), 0.100)

    def test_seeds_above_the_limit_have_failed(self):
        rows = self.table()
        self.assertEqual(rows["late"], "0.0260 (0.0270), **1 of 3**")
        self.assertEqual(rows["thin"], "0.0500 (0.0530), **1 of 3**")
        self.assertEqual(rows["none"], "0.0210 (0.0300), **1 of 3**")

    def test_runs_that_ended_with_an_error_have_failed(self):
        rows = self.table({"late": [None, 0.020, 0.022], "thin": [None, None, None]})
        self.assertEqual(rows["late"], "0.0210 (0.0220), **1 of 3**")
        self.assertEqual(rows["thin"], "–, **3 of 3**")

    def test_unstressed_failures_leave_the_limit_to_the_others(self):
        rows = self.table({"none": [None, 0.020, 0.020]})
        self.assertEqual(rows["none"], "0.0200 (0.0200), **1 of 3**")
        self.assertEqual(rows["late"], "0.0260 (0.0270), **2 of 3**")

    def test_all_good_is_not_bold(self):
        self.assertEqual(self.table({"late": [0.020, 0.020, 0.021]})["late"], "0.0200 (0.0210)")

    def test_the_command_writes_the_table(self):
        self.table()
        words = [STRESS / "survival.py", self.results.study_file,
                 f"--work_dir={self.results.work}", f"--bin={self.results.binaries}",
                 f"--data={self.results.folder}"]
        subprocess.run([*words, "--quick"], check=True, capture_output=True)
        written = (self.results.work / "report" / "tables" / "few_particles_survival.md")
        self.assertIn("| late | 0.0265 (0.0270), **2 of 2** |", written.read_text())
        self.results.study_file.write_text(STUDY.replace("[none, late, thin]", "late"))
        done = subprocess.run(words, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("dataset 'hall': expected a list of stresses", done.stderr)


if __name__ == "__main__":
    unittest.main()
