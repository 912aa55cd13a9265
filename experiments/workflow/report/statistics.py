# SPDX-License-Identifier: BSD-3-Clause
"""Means with intervals, and tests of pairs, over runs that may have failed.

A value is a number, or None for a run that ended without one: it failed, or its map is such that
the metric does not exist. A run without a value has no part in means (their counts say so); in the rank
test it is worse than every run with a value.

Intervals are Student's t intervals of the mean: no random numbers. They end where the possible values end,
and there is none of fewer than FEW values, which says less than the values themselves.
"""
import dataclasses
import math

import numpy
import scipy.stats

CONFIDENCE = 0.95
FEW = 5


@dataclasses.dataclass(frozen=True)
class Summary:
    """Of the n_ok values among n_all runs. All others are None without a value; the standard
    deviation (n - 1) with fewer than two, the interval of the mean, low to high, with fewer than FEW."""
    n_ok: int
    n_all: int
    mean: float | None = None
    std: float | None = None
    median: float | None = None
    min: float | None = None
    max: float | None = None
    low: float | None = None
    high: float | None = None


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Of a with b, by seed. The difference a - b is over the pairs in which both have a value; all
    below it is over all n_pairs. rank_sum is the sum of signed ranks, below 0 where a does better, and
    p tells whether that can be chance."""
    n_pairs: int
    difference: Summary
    rank_sum: float
    p: float
    better: int
    worse: int
    equal: int


def summarize(values, lowest=-math.inf, highest=math.inf):
    """lowest and highest bound what a value can be, and so its mean."""
    numbers = [v for v in values if v is not None]
    if not numbers:
        return Summary(0, len(values))
    n, mean = len(numbers), float(numpy.mean(numbers))
    std = float(numpy.std(numbers, ddof=1)) if n > 1 else None
    low = high = None
    if n >= FEW:
        half = float(scipy.stats.t.ppf(0.5 + CONFIDENCE / 2, n - 1)) * std / math.sqrt(n)
        low, high = max(lowest, mean - half), min(highest, mean + half)
    return Summary(n, len(values), mean, std, float(numpy.median(numbers)), float(min(numbers)),
                   float(max(numbers)), low, high)


def compare(a, b, lower_is_better, span=math.inf):
    """a and b map seeds to values; the seeds of both make pairs. span is the largest difference that
    two values can have."""
    seeds = sorted(a.keys() & b.keys())
    differences = [None if a[s] is None or b[s] is None else a[s] - b[s] for s in seeds]
    losses = [loss(a[s], b[s], lower_is_better) for s in seeds]
    return Comparison(
        n_pairs=len(seeds), difference=summarize(differences, -span, span),
        rank_sum=rank_sum(losses), p=signed_rank_p(losses), better=sum(x < 0 for x in losses),
        worse=sum(x > 0 for x in losses), equal=sum(x == 0 for x in losses))


def loss(a, b, lower_is_better):
    """How much worse a is than b: below 0 where better, infinite where only one has a value."""
    if a is None or b is None:
        return 0.0 if a is b else (math.inf if a is None else -math.inf)
    return float(a - b) if lower_is_better else float(b - a)


def rank_sum(differences):
    """Ranks of the sizes, with the signs of the differences, added up; zeros are left out."""
    nonzero = numpy.array([d for d in differences if d != 0])
    return float(numpy.sum(numpy.sign(nonzero) * scipy.stats.rankdata(numpy.abs(nonzero))))


def signed_rank_p(differences):
    """Two-sided p of Wilcoxon's signed-rank test that differences are symmetric about 0.

    Zeros are left out, as Wilcoxon does. Exact also with ties, which failed runs make (scipy falls
    back to the normal distribution there, which is wrong for few pairs): all 2^n choices of signs
    are counted by their sum of ranks."""
    nonzero = numpy.array([d for d in differences if d != 0])
    if len(nonzero) == 0:
        return 1.0
    # Mean ranks are multiples of a half; doubled, they index the table of counts.
    ranks = numpy.rint(2 * scipy.stats.rankdata(numpy.abs(nonzero))).astype(int)
    share = numpy.zeros(ranks.sum() + 1)
    share[0] = 1.0
    for rank in ranks:
        raised = numpy.zeros_like(share)
        raised[rank:] = share[:-rank]
        share = (share + raised) / 2
    positive = int(ranks[nonzero > 0].sum())
    tail = min(share[:positive + 1].sum(), share[positive:].sum())
    return float(min(1.0, 2 * tail))


def holm(ps):
    """Holm's correction: p values that keep the family-wise error, in the order given."""
    order = sorted(range(len(ps)), key=lambda k: ps[k])
    corrected = [1.0] * len(ps)
    largest = 0.0
    for place, k in enumerate(order):
        largest = max(largest, min(1.0, (len(ps) - place) * ps[k]))
        corrected[k] = largest
    return corrected
