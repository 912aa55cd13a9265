# SPDX-License-Identifier: BSD-3-Clause
"""Verdicts on claims, computed from paired tests: none is written by hand."""
import dataclasses
from typing import Any

from metrics import METRICS, TIMES

from . import selection, statistics
from .claims import Claim, Test, read_beside
from .table import Shown, Table, p_value
from .tables import heading

SIGNIFICANT = 0.05
# From the least to the best; of a single test only the first, the third and the last.
VERDICTS = ("not supported", "mixed", "undecided", "supported in part", "supported")
CAPTION = (
    "A with B, paired by seed. Where A may be worse by some allowance, B is worsened by that much "
    "first. p is of Wilcoxon's signed-rank test (failed runs are the worst), with Holm's "
    "correction for the {n} tests of this table. Supported: A is better with p < 0.05; not supported: A is "
    "worse with p < 0.05; undecided: neither. A claim is supported if all its tests are, in part if "
    "some are and none contradicts it, not supported if some contradict it and none supports it, mixed if "
    "there are both")
HEADER = ["claim", "algorithm", "study", "where", "A", "B", "metric", "mean A", "mean B", "expected of A",
          "better / worse / equal", "p", "p (Holm)", "verdict"]


@dataclasses.dataclass
class Finding:
    """What one test found on one pair of configurations."""
    claim: Claim
    test: Test
    config_a: Any
    config_b: Any
    mean_a: float | None
    mean_b: float | None
    comparison: statistics.Comparison
    p: float = 1.0  # with Holm's correction

    def verdict(self):
        if self.p >= SIGNIFICANT:
            return "undecided"
        return "supported" if self.comparison.rank_sum < 0 else "not supported"

    def seeds(self):
        return f"{self.comparison.better} / {self.comparison.worse} / {self.comparison.equal}"

    def line(self):
        where, a, b = selection.labels_of_pair(self.config_a, self.config_b)
        mean_a, mean_b = ("no value" if mean is None else f"{mean:.3g}"
                          for mean in (self.mean_a, self.mean_b))
        return (f"{heading(self.test.metric)}, {where}. {a}: {mean_a}; {b}: {mean_b}. "
                f"{self.test.expectation.text.capitalize()} on {self.comparison.better} of "
                f"{self.comparison.n_pairs} seeds, p {p_value(self.p).text}: {self.verdict()}")


@dataclasses.dataclass(frozen=True)
class Findings:
    """claims: (claim, verdict, lines with the numbers); tables: `verdicts`, a row a claim, and those of
    the tests behind them."""
    title: str
    source: str
    claims: list
    verdicts: Table
    tests: list


def judge_beside(all_measured):
    """The claims beside the studies; None if there is none on these studies."""
    claims = read_beside([m.study for m in all_measured])
    if claims is None or not claims.claims:
        return None
    return judge(claims, {m.study.name: m for m in all_measured})


def judge(claims, measured):
    """measured: by the study's name. Costs, which differ from rerun to rerun, are a family and a
    table of their own, so that they do not touch the other numbers."""
    findings = [finding for claim in claims.claims for test in claim.tests
                for finding in _findings(claim, test, measured[test.study])]
    tests = []
    for name, is_cost in (("claims", False), ("claims_cost", True)):
        family = [f for f in findings if (f.test.metric in TIMES) == is_cost]
        for finding, p in zip(family, statistics.holm([f.comparison.p for f in family])):
            finding.p = p
        if family:
            tests.append(Table(name, CAPTION.format(n=len(family)), HEADER,
                                [_row(f) for f in family]))
    judged, rows = [], []
    for claim in claims.claims:
        own = [f for f in findings if f.claim is claim]
        each = [f.verdict() for f in own]
        verdict = of_claim(each)
        judged.append((claim, verdict, [f.line() for f in own]))
        rows.append([claim.number, claim.place, claim.statement, claim.algorithm,
                     Shown(verdict, VERDICTS.index(verdict)),
                     f"{each.count('supported')} / {each.count('not supported')} / "
                     f"{each.count('undecided')}"])
    verdicts = Table("verdicts", "What the paper says, in our words, and what our runs say of it",
                     ["No.", "place", "claim", "of", "verdict",
                      "tests for / against / undecided"], rows)
    return Findings(claims.title, claims.source, judged, verdicts, tests)


def of_claim(of_tests):
    """The verdict on a claim, from those of its tests."""
    for_it, against = "supported" in of_tests, "not supported" in of_tests
    if for_it and against:
        return "mixed"
    if for_it and "undecided" in of_tests:
        return "supported in part"
    return min(of_tests, key=VERDICTS.index)


def _findings(claim, test, measured):
    lower = METRICS[test.metric].better == "lower"
    for config_a, config_b in selection.pairs(measured.study, test.a, test.b):
        a, b = (measured.values(config, test.metric) for config in (config_a, config_b))
        worsened = {seed: test.expectation.worsened(value, lower) for seed, value in b.items()}
        mean_a, mean_b = (statistics.summarize(list(side.values())).mean for side in (a, b))
        yield Finding(claim, test, config_a, config_b, mean_a, mean_b,
                      statistics.compare(a, worsened, lower))


def _row(finding):
    return [finding.claim.number, finding.claim.algorithm, finding.test.study,
            *selection.labels_of_pair(finding.config_a, finding.config_b),
            heading(finding.test.metric), finding.mean_a, finding.mean_b,
            finding.test.expectation.text, finding.seeds(), p_value(finding.comparison.p),
            p_value(finding.p), Shown(finding.verdict(), VERDICTS.index(finding.verdict()))]
