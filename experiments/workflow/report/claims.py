# SPDX-License-Identifier: BSD-3-Clause
"""What a paper says, as tests that runs can pass or fail: claims.yaml.

    title: of the report
    source: where the claims come from
    claims:
      - place: where the paper says it
        statement: the claim
        tests:
          ALGORITHM:
            - study: NAME
              compare: [{SELECTOR OF A}, {SELECTOR OF B}]
              metrics: [NAME, ...]
              expect: better

A claim gets a verdict for each algorithm that may be the one that the paper speaks of: an author's
text and our program may differ. `expect` is of A: better (than B), or "not worse by 10 %" (of B), or
"not worse by 0.1" (in the metric's unit).
"""
import dataclasses
import re
from typing import Any

from metrics import METRICS
from study import StudyError
from yaml_entry import did_you_mean, read_yaml

from . import selection


@dataclasses.dataclass(frozen=True)
class Expectation:
    """That A is better than B, or not worse by more than an allowance: a share of B and a number
    in the metric's unit."""
    share: float
    allowance: float
    text: str

    def worsened(self, value, lower_is_better):
        """What A has to be better than."""
        if value is None:
            return None
        by = abs(value) * self.share + self.allowance
        return value + by if lower_is_better else value - by


@dataclasses.dataclass(frozen=True)
class Test:
    study: str
    a: dict[str, Any]
    b: dict[str, Any]
    metric: str
    expectation: Expectation


@dataclasses.dataclass(frozen=True)
class Claim:
    """Of one algorithm; claims that share a number are one claim of the paper."""
    number: int
    place: str
    statement: str
    algorithm: str
    tests: list[Test]


@dataclasses.dataclass(frozen=True)
class Claims:
    title: str
    source: str
    claims: list[Claim]


def read_beside(studies):
    """Of the claims.yaml in the folder of the report's first study; None if there is none. Claims
    on other studies of the folder are left out."""
    file = studies[0].path.parent / "claims.yaml"
    return _read_claims(file, {study.name: study for study in studies}) if file.exists() else None


def _read_claims(file, studies):
    root = read_yaml(file)
    root.what = "claims"
    parts = _parts(root, ["title", "source", "claims"])
    read = []
    for number, entry in enumerate(parts["claims"].sequence(), 1):
        below = _parts(entry, ["place", "statement", "tests"])
        for algorithm, tests in below["tests"].mapping().items():
            found = [t for test in tests.sequence() for t in _read_tests(test, studies)]
            if not found:
                tests.fail("expected one test or more, found none")
            if all(found):
                read.append(Claim(number, below["place"].text(), below["statement"].text(), algorithm,
                                  found))
    return Claims(parts["title"].text(), parts["source"].text(), read)


def _parts(entry, names):
    """The values by key, all of which must be there."""
    parts = entry.mapping(names)
    for name in names:
        if name not in parts:
            entry.fail(f"'{name}' is missing")
    return parts


def _read_tests(entry, studies):
    """One a metric; None for a test on a study that is not in the report."""
    parts = _parts(entry, ["study", "compare", "metrics", "expect"])
    name = parts["study"].text()
    metrics = [_read_metric(metric) for metric in parts["metrics"].sequence()]
    expectation = _read_expectation(parts["expect"])
    if name not in studies:
        files = [file.stem for file in entry.file.parent.glob("*.yaml")]
        if name not in files:
            parts["study"].fail(f"no study '{name}' in this folder{did_you_mean(name, files)}")
        return [None]
    study, sides = studies[name], parts["compare"].sequence()
    if len(sides) != 2:
        parts["compare"].fail(f"expected two selectors, found {len(sides)}")
    coordinates = study.configurations[0].coordinates()
    a, b = ({axis: value.scalar() for axis, value in side.mapping(coordinates).items()}
            for side in sides)
    try:
        selection.pairs(study, a, b)
    except StudyError as error:
        parts["compare"].fail(str(error))
    return [Test(name, a, b, metric, expectation) for metric in metrics]


def _read_metric(entry):
    metric = entry.text()
    if metric not in METRICS:
        entry.fail(f"unknown metric '{metric}'{did_you_mean(metric, METRICS)}")
    if METRICS[metric].better == "none":
        entry.fail(f"of '{metric}' neither more nor less is better")
    return metric


def _read_expectation(entry):
    text = entry.text()
    if text == "better":
        return Expectation(0.0, 0.0, text)
    match = re.fullmatch(r"not worse by (\d+(?:\.\d+)?)( %)?", text)
    if not match:
        entry.fail("expected 'better', 'not worse by 10 %' or 'not worse by 0.1' (in the metric's "
                   f"unit), found {entry.found()}")
    number = float(match[1])
    return Expectation(number / 100, 0.0, text) if match[2] else Expectation(0.0, number, text)
