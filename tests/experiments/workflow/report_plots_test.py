#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import re
import unittest

import report_fixture
from report import plots


class PlotsTest(report_fixture.ResultsTestCase):
    def svg(self):
        (_, _, svg), = plots.plots(self.measured())
        return svg

    def texts(self):
        return re.findall(r"<text[^>]*>([^<]*)</text>", self.svg())

    def test_a_line_a_variant_over_the_values_of_the_axis(self):
        texts = self.texts()
        for text in ("particles", "5", "30", "GMapping", "improved", "boundary blur (m)",
                     "recall of occupied cells"):
            self.assertIn(text, texts)

    def test_same_numbers_same_bytes_and_no_date(self):
        self.assertEqual(self.svg(), self.svg())
        self.assertNotIn("dc:date", self.svg())

    def test_a_single_run_more_is_a_dot_more(self):
        dots = self.svg().count("<use")
        self.results.fail(self.results.run("improved", 5, 2))
        # In the panels of the three metrics that the study shows.
        self.assertEqual(self.svg().count("<use"), dots - 3)

    def test_cell_in_which_every_run_failed_is_left_out(self):
        for seed in self.results.study.seeds:
            for particles in (5, 30):
                self.results.fail(self.results.run("improved", particles, seed))
        self.assertIn("improved", self.texts())

    def test_without_axes_the_variants_are_the_axis(self):
        for config in self.results.study.configurations:
            del config.axes["particles"]
        self.assertEqual(plots.axes_to_plot(self.results.study), ["variant"])


if __name__ == "__main__":
    unittest.main()
