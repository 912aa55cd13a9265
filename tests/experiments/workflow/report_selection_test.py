#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import report_fixture
from report import selection
from study import StudyError


class PairsTest(report_fixture.ResultsTestCase):
    def pairs(self, a, b):
        return [(selection.label_within_dataset(x), selection.label_within_dataset(y))
                for x, y in selection.pairs(self.results.study, a, b)]

    def test_what_neither_names_is_alike(self):
        self.assertEqual(self.pairs({"variant": "improved"}, {"variant": "GMapping"}), [
            ("improved, particles 30", "GMapping, particles 30"),
            ("improved, particles 5", "GMapping, particles 5")])

    def test_what_one_names_is_free_in_the_other(self):
        self.assertEqual(
            self.pairs({"variant": "improved"}, {"variant": "GMapping", "particles": 30}), [
                ("improved, particles 30", "GMapping, particles 30"),
                ("improved, particles 5", "GMapping, particles 30")])

    def test_more_than_one_partner_is_an_error(self):
        with self.assertRaisesRegex(StudyError, "expected one configuration .*, found 2"):
            self.pairs({"variant": "improved", "particles": 5}, {"variant": "GMapping"})

    def test_no_pair_is_an_error(self):
        with self.assertRaisesRegex(StudyError, "no two configurations"):
            self.pairs({"particles": 7}, {"particles": 5})

    def test_label_of_a_pair_says_once_what_both_share(self):
        a, b = (self.results.run(variant, 5, 1).configuration
                for variant in ("improved", "GMapping"))
        self.assertEqual(selection.labels_of_pair(a, b),
                         ("building, particles 5", "improved", "GMapping"))


if __name__ == "__main__":
    unittest.main()
