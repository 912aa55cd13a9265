#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The studies and claims of experiments/paper fit each other and the executables."""
import os
import pathlib
import unittest

from report_fixture import ROOT
from report import checks
from study import load_study

PAPER = ROOT / "experiments" / "paper"
BINARIES = pathlib.Path(os.environ.get("GMAPPING_SPA_BINARIES", ROOT / "build" / "bin"))


@unittest.skipUnless((BINARIES / "gmapping_spa").exists(), f"{BINARIES} has no gmapping_spa")
class PaperTest(unittest.TestCase):
    def load(self, quick=False):
        return {file.stem: load_study(file, BINARIES, ROOT, quick)
                for file in sorted(PAPER.glob("*.yaml")) if file.stem != "claims"}

    def test_comparisons_and_claims_fit_the_studies_full_and_quick(self):
        for quick in (False, True):
            checks.check(list(self.load(quick).values()))

    def test_experiments_have_the_papers_particles_and_twenty_seeds(self):
        studies = self.load()
        for name, particles in (("experiment_1", [30, 15, 5]), ("experiment_2", [30, 5])):
            study = studies[name]
            self.assertEqual(len(study.figures), 3)  # kinds of odometry
            for figure in study.figures:
                _, columns, configs = figure.grid(study)
                self.assertEqual(columns, particles)
                self.assertEqual(len(configs), 3 * len(particles))
            self.assertEqual(len(study.seeds), 20)

    def test_quick_version_is_small(self):
        ids = {run.id for study in self.load(quick=True).values() for run in study.runs}
        self.assertLessEqual(len(ids), 60)

    def test_reproduce_runs_every_study(self):
        script = (PAPER / "reproduce.sh").read_text()
        listed = script[script.index("studies=("):].split("(")[1].split(")")[0].split()
        self.assertEqual(sorted(listed), sorted(self.load()))


if __name__ == "__main__":
    unittest.main()
