#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import itertools
import math
import pathlib
import sys
import unittest

import numpy
import scipy.stats

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "experiments" / "workflow"))
from report import statistics


class SummarizeTest(unittest.TestCase):
    def test_hand_computed(self):
        summary = statistics.summarize([2.0, 4.0, 5.0, 6.0, 13.0])
        self.assertEqual((summary.n_ok, summary.n_all), (5, 5))
        self.assertEqual((summary.mean, summary.median), (6.0, 5.0))
        self.assertEqual((summary.min, summary.max), (2.0, 13.0))
        # Squared deviations 16 + 4 + 1 + 0 + 49 = 70 over n - 1 = 4; t(0.975, 4) = 2.776445.
        self.assertAlmostEqual(summary.std, math.sqrt(70 / 4))
        half = 2.776445 * math.sqrt(70 / 4 / 5)
        self.assertAlmostEqual(summary.low, 6 - half, places=5)
        self.assertAlmostEqual(summary.high, 6 + half, places=5)

    def test_fewer_than_five_values_have_no_interval(self):
        summary = statistics.summarize([2.0, 4.0, 6.0, 12.0])
        self.assertEqual((summary.mean, summary.median, summary.min, summary.max),
                         (6.0, 5.0, 2.0, 12.0))
        self.assertIsNotNone(summary.std)
        self.assertIsNone(summary.low)
        self.assertIsNone(summary.high)

    def test_interval_ends_where_the_possible_values_end(self):
        values = [0.0, 0.0, 0.0, 0.0, 1.0]  # of a share; half of the interval is 0.56
        self.assertLess(statistics.summarize(values).low, 0.0)
        summary = statistics.summarize(values, lowest=0.0, highest=1.0)
        self.assertEqual(summary.low, 0.0)
        self.assertEqual(summary.high, statistics.summarize(values).high)
        self.assertEqual(statistics.summarize([1.0 - v for v in values], 0.0, 1.0).high, 1.0)

    def test_failed_runs_are_counted_and_have_no_part_in_the_mean(self):
        summary = statistics.summarize([1.0, None, 3.0])
        self.assertEqual((summary.n_ok, summary.n_all, summary.mean), (2, 3, 2.0))

    def test_one_value_has_no_interval(self):
        summary = statistics.summarize([1.5, None])
        self.assertEqual((summary.mean, summary.median, summary.min, summary.max), (1.5,) * 4)
        self.assertIsNone(summary.low)
        self.assertIsNone(summary.std)

    def test_no_value(self):
        self.assertEqual(statistics.summarize([None, None]), statistics.Summary(0, 2))

    def test_interval_is_that_of_the_one_sample_t_test(self):
        values = numpy.random.default_rng(1).normal(3.0, 2.0, 15)
        summary = statistics.summarize(list(values))
        # The t test of the mean against an end of its 95 % interval has p = 0.05.
        for end in (summary.low, summary.high):
            self.assertAlmostEqual(scipy.stats.ttest_1samp(values, end).pvalue, 0.05)


class CompareTest(unittest.TestCase):
    def test_hand_computed(self):
        a = {1: 1.0, 2: 2.0, 3: 7.0, 4: 3.0}
        b = {1: 2.0, 2: 4.0, 3: 4.0, 4: 3.0}
        comparison = statistics.compare(a, b, lower_is_better=True)
        self.assertEqual((comparison.better, comparison.worse, comparison.equal), (2, 1, 1))
        self.assertEqual(comparison.difference.mean, 0.0)
        # Ranks 1, 2 (negative) and 3 (positive): the sums 3 and 3 are the likeliest of all.
        self.assertEqual(comparison.p, 1.0)

    def test_where_higher_is_better_the_larger_value_wins(self):
        comparison = statistics.compare({1: 0.9, 2: 0.8}, {1: 0.5, 2: 0.6}, lower_is_better=False)
        self.assertEqual((comparison.better, comparison.worse), (2, 0))
        self.assertAlmostEqual(comparison.difference.mean, 0.3)

    def test_pairs_are_made_by_seed(self):
        comparison = statistics.compare({1: 1.0, 2: 5.0}, {2: 7.0, 3: 0.0}, lower_is_better=True)
        self.assertEqual((comparison.n_pairs, comparison.difference.mean), (1, -2.0))

    def test_difference_of_shares_stays_between_minus_one_and_one(self):
        a, b = dict(enumerate([0.0, 0.0, 0.0, 0.0, 1.0])), dict.fromkeys(range(5), 1.0)
        self.assertLess(statistics.compare(a, b, lower_is_better=True).difference.low, -1.0)
        self.assertEqual(statistics.compare(a, b, lower_is_better=True, span=1.0).difference.low, -1.0)

    def test_failed_run_is_worst_in_ranks_and_left_out_of_the_mean(self):
        a = {1: None, 2: 1.0, 3: 1.0, 4: None}
        b = {1: 9.0, 2: 2.0, 3: 4.0, 4: None}
        comparison = statistics.compare(a, b, lower_is_better=True)
        self.assertEqual((comparison.n_pairs, comparison.difference.n_ok), (4, 2))
        self.assertEqual((comparison.better, comparison.worse, comparison.equal), (2, 1, 1))
        self.assertEqual(comparison.difference.mean, -2.0)
        # Same ranks as with a finite difference larger than all others.
        self.assertEqual(comparison.p, statistics.signed_rank_p([100.0, -1.0, -3.0]))

    def test_failed_run_is_worst_where_higher_is_better_too(self):
        comparison = statistics.compare({1: None}, {1: 0.1}, lower_is_better=False)
        self.assertEqual((comparison.better, comparison.worse), (0, 1))


class SignedRankTest(unittest.TestCase):
    def test_equals_scipy_where_there_are_no_ties(self):
        for n in (3, 8, 20, 40):
            differences = numpy.random.default_rng(n).normal(0.4, 1.0, n)
            self.assertAlmostEqual(statistics.signed_rank_p(differences),
                                   scipy.stats.wilcoxon(differences, mode="exact").pvalue, 12)

    def test_equals_the_count_of_all_signs_with_ties(self):
        for differences in ([1, 1, -1, 2, 2, 3], [math.inf, math.inf, -1, 2], [-1, -1, -1, -1, 5]):
            ranks = scipy.stats.rankdata(numpy.abs(differences))
            seen = ranks[numpy.array(differences) > 0].sum()
            sums = [sum(r for r, up in zip(ranks, signs) if up)
                    for signs in itertools.product((False, True), repeat=len(ranks))]
            tail = min(sum(s <= seen for s in sums), sum(s >= seen for s in sums)) / len(sums)
            self.assertAlmostEqual(statistics.signed_rank_p(differences), min(1.0, 2 * tail))

    def test_zeros_are_left_out(self):
        self.assertEqual(statistics.signed_rank_p([0, 1, 2, 0, 3]),
                         statistics.signed_rank_p([1, 2, 3]))
        self.assertEqual(statistics.signed_rank_p([0, 0]), 1.0)

    def test_smallest_p_of_n_pairs_is_two_in_two_to_the_n(self):
        self.assertAlmostEqual(statistics.signed_rank_p(range(1, 21)), 2 / 2**20)


class HolmTest(unittest.TestCase):
    def test_hand_computed(self):
        # Sorted 0.01 x 4, 0.02 x 3, 0.03 x 2 (= 0.06 again), 0.9 x 1.
        corrected = statistics.holm([0.03, 0.01, 0.9, 0.02])
        for found, expected in zip(corrected, [0.06, 0.04, 0.9, 0.06]):
            self.assertAlmostEqual(found, expected)

    def test_stays_at_most_one(self):
        self.assertEqual(statistics.holm([0.6, 0.7]), [1.0, 1.0])

    def test_one_test_stays_as_it_is(self):
        self.assertEqual(statistics.holm([0.04]), [0.04])


if __name__ == "__main__":
    unittest.main()
