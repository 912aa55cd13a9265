#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table "what it survives" of a study of stressed datasets, as Markdown and CSV.

    survival.py STUDY.yaml --work_dir=RESULTS [--quick] [--output=FOLDER]

A row a stress, a column a dataset: the mean error of the relations (median over the seeds, the worst
in brackets), and how many seeds failed. Who failed: a run that ended with an error or without a score,
and one whose error is above the limit, which is a multiple of what the same dataset gives unstressed.
"""
import pathlib
import statistics
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments" / "workflow"))

from datasets import UNSTRESSED
from make_report import measure
from report.table import Shown, Table
from study import Study, StudyError
from table_script import write_table

METRIC = "relation_error_m"
MULTIPLE, AT_LEAST_M = 1.25, 0.005  # of the unstressed error, and more than it
# Little is left to see: a greater error is no failure.
POOR_SIGHT = {"fov90", "range5_6", "every10", "thin", "thin1m"}
MULTIPLE_OF_POOR_SIGHT = 2.5


def limit_m(kind: str, unstressed_m: float) -> float:
    """The error above which a seed has failed."""
    multiple = MULTIPLE_OF_POOR_SIGHT if kind in POOR_SIGHT else MULTIPLE
    return max(multiple * unstressed_m, unstressed_m + AT_LEAST_M)


def dataset_and_kind(config) -> tuple[str, str]:
    """Datasets with a list of stresses are called 'NAME KIND'."""
    dataset, _, kind = config.dataset.rpartition(" ")
    return dataset, kind


def entry(errors_m: list[float | None], limit: float | None) -> Shown | None:
    """None: no run is there yet. Without a limit nothing can be called too large."""
    if not errors_m:
        return None
    good = [error for error in errors_m if error is not None]
    failed = sum(error is None or (limit is not None and error > limit) for error in errors_m)
    median = statistics.median(good) if good else None
    shown = f"{median:.4f} ({max(good):.4f})" if good else "–"
    return Shown(f"{shown}, **{failed} of {len(errors_m)}**" if failed else shown, median)


def survival(measured) -> Table:
    rows, unstressed = {}, {}
    for config in measured.study.configurations:
        dataset, kind = dataset_and_kind(config)
        setting = tuple((k, v) for k, v in config.coordinates().items() if k != "dataset" and v != "")
        errors_m = list(measured.values(config, METRIC).values())
        rows.setdefault((kind, setting), {})[dataset] = errors_m
        good = [error for error in errors_m if error is not None]
        if kind == UNSTRESSED and good:
            unstressed[setting, dataset] = statistics.median(good)
    datasets = list(dict.fromkeys(dataset_and_kind(c)[0] for c in measured.study.configurations))
    table = []
    for (kind, setting), by_dataset in rows.items():
        entries = []
        for dataset in datasets:
            plain_m = unstressed.get((setting, dataset))
            limit = None if plain_m is None else limit_m(kind, plain_m)
            entries.append(entry(by_dataset.get(dataset, []), limit))
        table.append([kind, *(value for _, value in setting), *entries])
    count = len(measured.study.seeds)
    settings = [name for name, _ in next(iter(rows))[1]]
    return Table(
        f"{measured.study.name}_survival",
        f"{measured.study.title}: mean error of the relations in m, median over "
        f"{count} {'seed' if count == 1 else 'seeds'} (the worst of those that ended), "
        "**how many failed**. "
        "Failed is a run that ended with an error, or one whose error is above "
        f"{MULTIPLE:g} x the unstressed median, or {1000 * AT_LEAST_M:g} mm more if that is more; "
        f"above {MULTIPLE_OF_POOR_SIGHT:g} x for {', '.join(sorted(POOR_SIGHT))}.",
        ["stress", *settings, *datasets], table)


def make(study: Study, work_dir: pathlib.Path) -> Table:
    for config in study.configurations:
        if not all(dataset_and_kind(config)):
            raise StudyError(f"{study.path}: dataset '{config.dataset}': expected a list of "
                             "stresses, found none")
    return survival(measure(study, work_dir))


if __name__ == "__main__":
    write_table(__doc__, make)
