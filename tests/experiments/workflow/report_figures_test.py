#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import io
import unittest

import report_fixture
from PIL import Image
from report import figures


class FiguresTest(report_fixture.ResultsTestCase):
    def figures(self):
        return dict(figures.figures(self.measured(), self.results.work / "scores"))

    def test_a_figure_and_its_error_maps_are_files_named_after_it(self):
        found = self.figures()
        self.assertEqual(list(found), ["few_particles_two_by_two.png",
                                       "few_particles_two_by_two_error_maps.png"])
        for png in found.values():
            width, height = Image.open(io.BytesIO(png)).size
            self.assertEqual(width, round(2 * figures.PANEL_WIDTH * figures.DPI))
            self.assertGreater(height, width / 2)  # two rows of maps that are wider than high

    def test_the_worst_run_stands_beside_the_median_one(self):
        text = self.results.study_file.read_text()
        self.results.study_file.write_text(
            text.replace("columns: particles}", "columns: particles, runs: [median, worst]}"))
        self.results.study = self.results.load()
        png = self.figures()["few_particles_two_by_two.png"]
        self.assertEqual(Image.open(io.BytesIO(png)).size[0],
                         round(4 * figures.PANEL_WIDTH * figures.DPI))

    def test_the_same_results_give_the_same_bytes(self):
        self.assertEqual(self.figures(), self.figures())

    def test_a_cell_whose_runs_failed_leaves_its_place_empty(self):
        def wall():
            image = Image.open(io.BytesIO(self.figures()["few_particles_two_by_two.png"]))
            return sum(pixel == (0, 0, 0) for pixel in image.convert("RGB").getdata())
        before = wall()
        for seed in range(1, 7):
            self.results.fail(self.results.run("improved", 5, seed))
        self.assertAlmostEqual(wall() / before, 0.75, delta=0.05)

    def test_a_study_without_figures_has_no_files(self):
        text = self.results.study_file.read_text()
        self.results.study_file.write_text(text[:text.index("figures:")] + "quick: {seeds: 1-2}\n")
        self.results.study = self.results.load()
        self.assertEqual(self.figures(), {})


if __name__ == "__main__":
    unittest.main()
