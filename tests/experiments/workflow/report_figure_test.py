#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import report_fixture
from study import StudyError

FIGURE = "{title: Two by two, rows: variant, columns: particles}"


class FigureTest(report_fixture.ResultsTestCase):
    def figure(self, text, datasets="building: {world: paper_building.yaml}"):
        self.results.study_file.write_text(report_fixture.STUDY.replace(FIGURE, text).replace(
            "building: {world: paper_building.yaml}", datasets))
        study = self.results.load()
        return study, study.figures[0]

    def complaint(self, text, **datasets):
        with self.assertRaises(StudyError) as caught:
            self.figure(text, **datasets)
        return str(caught.exception).replace(f"{self.results.folder}/", "")

    def test_rows_and_columns_are_in_the_order_of_the_study(self):
        study, figure = self.figure(FIGURE)
        rows, columns, configs = figure.grid(study)
        self.assertEqual((rows, columns), (["GMapping", "improved"], [30, 5]))
        for (row, column), config in configs.items():
            self.assertEqual((config.variant, config.axes["particles"]), (row, column))

    TWO_DATASETS = "{a: {world: paper_building.yaml}, b: {world: paper_building.yaml}}"

    def two_datasets(self, text):
        self.results.study_file.write_text(report_fixture.STUDY.replace(FIGURE, text).replace(
            "\n  building: {world: paper_building.yaml}", f" {self.TWO_DATASETS}"))
        return self.results.load()

    def test_dataset_chooses_among_datasets(self):
        study = self.two_datasets("{title: b, rows: variant, columns: particles, dataset: b}")
        _, _, configs = study.figures[0].grid(study)
        self.assertEqual({config.dataset for config in configs.values()}, {"b"})

    def test_two_configurations_at_one_place_are_an_error(self):
        with self.assertRaisesRegex(StudyError, "yaml:16: .*more than one configuration at a place"):
            self.two_datasets(FIGURE)

    def test_mistakes_are_named_with_file_and_line(self):
        for text, complaint in (
                ("{rows: variant, columns: particles}", "few_particles.yaml:17: figures: 'title' is"
                 " missing"),
                ("{title: t, rows: variant, columns: particle}", "few_particles.yaml:17: columns: "
                 "'particle' is no axis of the study; did you mean 'particles'?"),
                ("{title: t, rows: variant, columns: particles, dataset: bilding}",
                 "few_particles.yaml:17: figures: selects no configuration of the study"),
                ("{title: t, rows: variant, columns: particles, runs: [best]}",
                 "few_particles.yaml:17: runs: expected median or worst, found 'best'")):
            with self.subTest(text):
                self.assertEqual(self.complaint(text), complaint)


if __name__ == "__main__":
    unittest.main()
