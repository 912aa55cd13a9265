#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of a study of simulated situations, as Markdown and CSV.

    situations_table.py STUDY.yaml --work_dir=RESULTS [--quick] [--output=FOLDER]

A row a situation, a column a setting: the error of the position (median over the seeds, the worst in
brackets), and how many seeds failed. Who failed: a run that ended with an error, and one whose error
of position or heading is above the bound in situations_bounds.yml. With wheel odometry errors of the
wheels cannot be mended: there a bound holds only where the wheels are exact.
"""
import pathlib
import statistics
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments" / "workflow"))

from make_report import measure
from report.table import Shown, Table
from study import Study
from table_script import write_table
from yaml_entry import read_yaml

BOUNDS = pathlib.Path(__file__).resolve().parent / "situations_bounds.yml"


def read_bounds(path: pathlib.Path, situations: list[str]) -> dict[str, tuple[float, float]]:
    """(m, deg) of each situation; complains about one that has none."""
    bounds = {}
    root = read_yaml(path)
    for name, numbers in root.mapping().items():
        try:
            metres, degrees = (float(item.text()) for item in numbers.sequence())
        except ValueError:
            numbers.fail("expected two numbers [m, deg]")
        bounds[name] = metres, degrees
    for name in situations:
        if name not in bounds:
            root.fail(f"expected a bound for '{name}', found none")
    return bounds


def is_judged(run) -> bool:
    """Whether it can be asked to keep its bound."""
    return "--odometry=wheel" not in run.argv or "--wheels=exact" in run.log_argv


def entry(errors: list[tuple[float | None, float | None]],
          bound: tuple[float, float] | None) -> Shown | None:
    """`errors` in (m, deg) by seed, None after a failure; nothing is judged without a bound."""
    if not errors:
        return None
    good = [error_m for error_m, _ in errors if error_m is not None]
    failed = sum(
        error_m is None or (bound is not None and (error_m > bound[0] or error_deg > bound[1]))
        for error_m, error_deg in errors)
    median = statistics.median(good) if good else None
    shown = f"{median:.3f} ({max(good):.3f})" if good else "–"
    if bound is None:
        shown = f"*{shown}*"
    return Shown(f"{shown}, **{failed} of {len(errors)}**" if failed else shown, median)


def situations(measured, bounds: dict[str, tuple[float, float]]) -> Table:
    rows: dict[str, dict[str, Shown | None]] = {}
    judged = {run.configuration.label(): is_judged(run) for run in measured.study.runs}
    for config in measured.study.configurations:
        setting = config.label().removeprefix(f"{config.dataset}, ")
        metres = measured.values(config, "ate_rmse_m")
        degrees = measured.values(config, "heading_rmse_deg")
        bound = bounds[config.dataset] if judged[config.label()] else None
        rows.setdefault(config.dataset, {})[setting] = entry(
            [(metres[seed], degrees[seed]) for seed in metres], bound)
    settings = list(dict.fromkeys(setting for row in rows.values() for setting in row))
    return Table(
        f"{measured.study.name}_readme",
        f"{measured.study.title}: RMSE of the position in m, median over "
        f"{len(measured.study.seeds)} seeds (the worst of those that ended), **how many failed**. "
        "Failed is a run that ended with an error, or whose RMSE of position or heading is above the "
        "bound; *in italics* what is not judged, since errors of the wheels remain.",
        ["situation", "bound", *settings],
        [[situation, f"{bounds[situation][0]:g} m, {bounds[situation][1]:g} deg",
          *(row.get(s) for s in settings)] for situation, row in rows.items()])


def make(study: Study, work_dir: pathlib.Path) -> Table:
    bounds = read_bounds(BOUNDS, list(dict.fromkeys(c.dataset for c in study.configurations)))
    return situations(measure(study, work_dir), bounds)


if __name__ == "__main__":
    write_table(__doc__, make)
