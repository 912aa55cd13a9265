#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import report_fixture
from report import shown_run


class ShownRunTest(report_fixture.ResultsTestCase):
    def setUp(self):
        super().setUp()
        self.configuration = self.results.run("improved", 5, 1).configuration

    def set_blurs(self, *blurs):
        for seed, blur in enumerate(blurs, 1):
            self.results.write(self.results.run("improved", 5, seed), blur=blur)

    def median(self):
        return shown_run.seed_of(self.measured(), self.configuration, "median")

    def test_the_better_of_the_two_in_the_middle(self):
        self.set_blurs(0.6, 0.1, 0.5, 0.2, 0.4, 0.3)
        self.assertEqual(self.median(), 6)

    def test_failed_runs_come_last(self):
        self.set_blurs(0.6, 0.1, 0.5, 0.2, 0.4, 0.3)
        self.results.fail(self.results.run("improved", 5, 2))
        self.results.fail(self.results.run("improved", 5, 4))
        # 0.3 (seed 6), 0.4, 0.5 (seed 3), 0.6, failed, failed.
        self.assertEqual(self.median(), 3)

    def test_of_equal_runs_the_seed_decides(self):
        self.set_blurs(*[0.2] * 6)
        self.assertEqual(self.median(), 3)

    def test_the_worst_is_the_last_a_failed_one_before_all(self):
        self.set_blurs(0.6, 0.1, 0.5, 0.2, 0.4, 0.3)
        self.assertEqual(shown_run.seed_of(self.measured(), self.configuration, "worst"), 1)
        self.results.fail(self.results.run("improved", 5, 4))
        self.assertEqual(shown_run.seed_of(self.measured(), self.configuration, "worst"), 4)

    def test_missing_runs_have_no_part(self):
        for seed in (2, 3, 4, 5, 6):
            self.results.remove(self.results.run("improved", 5, seed))
        self.assertEqual(self.median(), 1)
        self.results.remove(self.results.run("improved", 5, 1))
        self.assertIsNone(self.median())


if __name__ == "__main__":
    unittest.main()
