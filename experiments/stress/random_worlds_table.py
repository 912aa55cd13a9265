#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of a study of random buildings, as Markdown and CSV.

    random_worlds_table.py STUDY.yaml --work_dir=RESULTS [--quick] [--output=FOLDER]

A row a kind of building and a setting: the error of the position (median over the seeds, the worst in
brackets), how many seeds failed, and how many of these failed silently: nothing under `health` in
run.json says that the trajectory may be wrong there. Who failed: a run that ended with an error, and
one whose error is above a part of the way driven.
"""
from __future__ import annotations

import dataclasses
import pathlib
import statistics
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments" / "workflow"))

from make_report import measure
from report.table import Shown, Table
from results import Result
from study import Study
from table_script import write_table

LEAST_BOUND_M, BOUND_M_PER_M = 0.05, 0.002

# Findings that say that the trajectory may be wrong. Those of the odometry are not among them: it is
# known to be bad, and left out or corrected.
SAYING = {
    "ambiguous", "ambiguous_scan", "motion_unobserved", "lost", "unmatched_scan", "new_piece",
    "piece_not_joined", "unproven_closures", "backend_rejected_closure", "backend_failed", "backend_late",
    "backend_not_converged", "few_hits", "blind_scan"}


@dataclasses.dataclass(frozen=True)
class Verdict:
    error_m: float | None  # None: the run ended with an error, which says enough
    failed: bool
    said: bool

    def silent(self) -> bool:
        return self.failed and not self.said


def way_m(truth: pathlib.Path) -> float:
    """That the robot drove."""
    positions = np.loadtxt(truth, comments="#", usecols=(1, 2), ndmin=2)
    return float(np.hypot(*np.diff(positions, axis=0).T).sum())


def bound_m(way: float) -> float:
    return max(LEAST_BOUND_M, BOUND_M_PER_M * way)


def judge(result: Result, way: float) -> Verdict:
    if result.record is None:
        return Verdict(None, failed=True, said=True)
    error_m = result.scores["ate_rmse_m"]
    return Verdict(error_m, failed=error_m is None or error_m > bound_m(way),
                   said=not SAYING.isdisjoint(result.record["health"]))


def row(verdicts: dict[int, Verdict]) -> list:
    """By seed: how many there are, errors, failures, those that were silent, and false alarms."""
    errors = [v.error_m for v in verdicts.values() if v.error_m is not None]
    failed = {seed: v for seed, v in verdicts.items() if v.failed}
    silent = sum(v.silent() for v in failed.values())
    alarms = sum(v.said for v in verdicts.values() if not v.failed)
    median = statistics.median(errors) if errors else None
    return [
        len(verdicts), Shown(f"{median:.3f} ({max(errors):.3f})" if errors else "–", median),
        len(failed), Shown(f"**{silent}**" if silent else "0", silent),
        f"{alarms} of {len(verdicts) - len(failed)}",
        ", ".join(f"**{seed}**" if v.silent() else str(seed) for seed, v in failed.items()) or "none"]


def random_worlds(measured, work_dir: pathlib.Path) -> Table:
    rows = []
    for config in measured.study.configurations:
        verdicts = {}
        for seed in measured.study.seeds:
            result = measured.result(config, seed)
            if result is not None:
                truth = work_dir / "logs" / result.run.log_id / "truth.tum"
                verdicts[seed] = judge(result, way_m(truth) if truth.exists() else 0.0)
        rows.append([config.dataset, config.label().removeprefix(f"{config.dataset}, "),
                     *row(verdicts)])
    return Table(
        f"{measured.study.name}_readme",
        f"{measured.study.title}: RMSE of the position in m, median over the worlds (the worst of those "
        "that ended). Failed is a run that ended with an error, or whose RMSE is above "
        f"{LEAST_BOUND_M:g} m and above {100 * BOUND_M_PER_M:g} % of the way driven; **silently**, if "
        "nothing under `health` says that the trajectory may be wrong. A false alarm says so, and is "
        "within the bound.",
        ["building", "setting", "worlds", "error", "failed", "silently", "false alarms",
         "seeds that failed"], rows)


def make(study: Study, work_dir: pathlib.Path) -> Table:
    return random_worlds(measure(study, work_dir), work_dir)


if __name__ == "__main__":
    write_table(__doc__, make)
