#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import report_fixture
from report import published
from report.measured import Measured
from report.table import text
from study import StudyError

PUBLISHED = """
- system: Elders
  source: a paper
  hall: {translation_m: [0.5, 0.25], rotation_deg: [1.5]}
  elsewhere: {translation_m: [0.1]}
- system: Juniors
  source: another
  elsewhere: {translation_m: [0.1]}
"""


class PublishedTest(report_fixture.ResultsTestCase):
    def setUp(self):
        super().setUp()
        file = self.results.study_file
        (self.results.folder / "carmen").mkdir()
        (self.results.folder / "carmen" / "hall.clf").write_text("not read here")
        file.write_text(file.read_text()
                        .replace("building: {world: paper_building.yaml}", '"*": {carmen: "*"}')
                        .replace("map_blur_m, map_recall", "relation_error_m"))
        self.results.study = self.results.load()
        for run in self.results.study.runs:
            self.results.write(run)
            self.results.write_scores(run, {
                "relation_error_m": 0.01 * run.configuration.axes["particles"] + 0.001 * run.seed,
                "relation_std_m": 0.002, "relation_rotation_deg": 0.25})

    def tables(self, content=PUBLISHED):
        (self.results.folder / "published.yaml").write_text(content)
        return published.tables_beside(self.measured())

    def complaint(self, old, new):
        self.assertIn(old, PUBLISHED)
        with self.assertRaises(StudyError) as caught:
            self.tables(PUBLISHED.replace(old, new))
        return str(caught.exception).replace(f"{self.results.folder}/", "")

    def test_published_systems_come_first_then_the_mean_of_our_seeds(self):
        table = self.tables()["published"]
        self.assertEqual(table.header, ["system", "source", "hall"])
        self.assertEqual([[text(value) for value in row] for row in table.rows], [
            ["Elders", "a paper", "0.5000 ± 0.2500 / 1.50"],
            ["Juniors", "another", "–"],
            ["GMapping, particles 30", "this study", "0.3035 ± 0.0020 / 0.25"],
            ["GMapping, particles 5", "this study", "0.0535 ± 0.0020 / 0.25"],
            ["improved, particles 30", "this study", "0.3035 ± 0.0020 / 0.25"],
            ["improved, particles 5", "this study", "0.0535 ± 0.0020 / 0.25"]])

    def test_without_published_results_there_is_no_table(self):
        self.assertEqual(published.tables_beside(self.measured()), {})

    def test_without_relations_there_is_no_table(self):
        for run in self.results.study.runs:
            self.results.write_scores(run, {"map_corners": 3})
        self.assertEqual(self.tables(), {})

    def test_what_is_wrong_is_named_with_its_line(self):
        self.assertEqual(self.complaint("[0.5, 0.25]", "[half]"),
                         "published.yaml:4: translation_m: expected [mean] or "
                         "[mean, standard deviation]")
        self.assertIn("published.yaml:2: study: 'source' is missing",
                      self.complaint("  source: a paper\n", ""))
        self.assertIn("unknown key 'rotaton_deg'; did you mean 'rotation_deg'?",
                      self.complaint("rotation_deg", "rotaton_deg"))


if __name__ == "__main__":
    unittest.main()
