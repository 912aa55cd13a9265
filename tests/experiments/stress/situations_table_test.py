# SPDX-License-Identifier: BSD-3-Clause
"""The table of situations: failures are counted against bounds, and every situation has one."""
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
STRESS = ROOT / "experiments" / "stress"
sys.path[:0] = [str(STRESS), str(ROOT / "tests" / "experiments" / "workflow")]

import report_fixture
import situations_table
from report.table import text
from study import StudyError
from yaml_entry import read_yaml

STUDY = """
title: Situations
datasets:
  exact: {world: paper_building.yaml, simulate: {wheels: exact}}
  noisy: {world: paper_building.yaml}
seeds: 1-3
flags: {particles: 5}
variants:
  scans: {}
  wheels: {odometry: wheel}
metrics: [ate_rmse_m]
quick: {seeds: 1-2}
"""
BOUNDS = {"exact": (0.02, 1.0), "noisy": (0.03, 2.0)}
GOOD = {("exact", "scans"): [(0.01, 0.5), (0.012, 0.5), (0.02, 1.0)],
        ("exact", "wheels"): [(0.01, 0.5)] * 3,
        ("noisy", "scans"): [(0.03, 2.0)] * 3,
        ("noisy", "wheels"): [(0.9, 9.0), (0.8, 9.0), (0.7, 9.0)]}


def flag(name):
    return f"<flag><name>{name}</name><type>string</type></flag></group>"


class SituationResults(report_fixture.Results):
    def __init__(self, folder, errors):
        self.errors = errors
        words = report_fixture.HELP
        for name in ("wheels", "odometry"):
            words = words.replace("</group>", flag(name))
        with mock.patch.object(report_fixture, "HELP", words):
            super().__init__(folder, STUDY)

    def write(self, run):
        config = run.configuration
        metres, degrees = self.errors[config.dataset, config.variant][run.seed - 1]
        folder = self.work / "runs" / run.id
        folder.mkdir(parents=True, exist_ok=True)
        report_fixture.write_json(folder / "outcome.json", {"exit_status": int(metres is None)})
        report_fixture.write_json(folder / "run.json", {})
        self.write_scores(run, {"ate_rmse_m": metres, "heading_rmse_deg": degrees})


class SituationsTableTest(unittest.TestCase):
    def table(self, errors=None):
        """Rows as text by situation: bound, scans, wheels."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.results = SituationResults(folder.name, GOOD | (errors or {}))
        table = situations_table.situations(
            report_fixture.measure(self.results.study, self.results.work), BOUNDS)
        self.assertEqual(table.header, ["situation", "bound", "scans", "wheels"])
        return {row[0]: [text(cell) for cell in row[1:]] for row in table.rows}

    def test_what_is_within_its_bound_has_not_failed(self):
        self.assertEqual(self.table()["exact"],
                         ["0.02 m, 1 deg", "0.012 (0.020)", "0.010 (0.010)"])

    def test_too_far_too_much_turned_or_ended_by_an_error_is_failed(self):
        rows = self.table({("exact", "scans"): [(0.021, 0.5), (0.01, 1.1), (None, None)]})
        self.assertEqual(rows["exact"][1], "0.015 (0.021), **3 of 3**")

    def test_all_failed_runs_have_no_median(self):
        rows = self.table({("exact", "scans"): [(None, None)] * 3})
        self.assertEqual(rows["exact"][1], "–, **3 of 3**")

    def test_wheel_odometry_is_judged_where_the_wheels_are_exact_only(self):
        rows = self.table({("exact", "wheels"): [(0.5, 0.1)] * 3})
        self.assertEqual(rows["exact"][2], "0.500 (0.500), **3 of 3**")
        self.assertEqual(rows["noisy"][2], "*0.800 (0.900)*")

    def test_a_situation_without_a_bound_is_an_error(self):
        with self.assertRaisesRegex(StudyError, "expected a bound for 'new', found none"):
            situations_table.read_bounds(situations_table.BOUNDS, ["new"])
        file = self.write("a: [1]\n")
        with self.assertRaisesRegex(StudyError, r":1: .*expected two numbers \[m, deg\]"):
            situations_table.read_bounds(file, [])

    def test_all_situations_have_bounds_and_all_bounds_a_situation(self):
        names = set()
        for study in ("situations.yaml", "situations_particles.yaml"):
            names |= read_yaml(STRESS / study).mapping()["datasets"].mapping().keys()
        self.assertEqual(
            situations_table.read_bounds(situations_table.BOUNDS, sorted(names)).keys(), names)

    def test_the_command_names_what_is_missing(self):
        self.table()
        words = [STRESS / "situations_table.py", self.results.study_file,
                 f"--work_dir={self.results.work}", f"--bin={self.results.binaries}",
                 f"--data={self.results.folder}"]
        done = subprocess.run(words, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("expected a bound for 'exact', found none", done.stderr)

    def write(self, words):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = pathlib.Path(folder.name) / "bounds.yaml"
        file.write_text(words)
        return file


if __name__ == "__main__":
    unittest.main()
