# SPDX-License-Identifier: BSD-3-Clause
"""Figures of maps in rows and columns, as a study asks for them:

    figures:
      - {title: Maps, rows: variant, columns: particles, dataset: building, where: {backend: spa},
         runs: [median, worst]}

`dataset` and `where` are needed only where there is more than one configuration at a place. `runs` are
those that are shown side by side of each configuration; without it, the median run.
"""
from __future__ import annotations

import dataclasses
from typing import Any

from yaml_entry import Entry, did_you_mean

KEYS = ["title", "rows", "columns", "dataset", "where", "runs"]
RUNS = ["median", "worst"]


@dataclasses.dataclass(frozen=True)
class Figure:
    """`rows` and `columns` name coordinates of configurations; `selector` holds the others to one value."""
    title: str
    rows: str
    columns: str
    selector: dict[str, Any]
    runs: list[str]

    def grid(self, study) -> tuple[list, list, dict]:
        """Values of the rows, of the columns, and the configuration at (row, column)."""
        configs = {(c.coordinates()[self.rows], c.coordinates()[self.columns]): c
                 for c in study.select(self.selector)}
        rows, columns = (list(dict.fromkeys(place[k] for place in configs)) for k in (0, 1))
        return rows, columns, configs


def read_figures(entry: Entry, study) -> list[Figure]:
    return [_read_figure(below, study) for below in entry.sequence()]


def _read_figure(entry: Entry, study) -> Figure:
    parts = entry.mapping(KEYS)
    for name in ("title", "rows", "columns"):
        if name not in parts:
            entry.fail(f"'{name}' is missing")
    known = study.configurations[0].coordinates()
    for name in ("rows", "columns"):
        value = parts[name].text()
        if value not in known:
            parts[name].fail(f"'{value}' is no axis of the study{did_you_mean(value, known)}")
    selector = {name: value.scalar() for name, value in parts["where"].mapping(known).items()} \
        if "where" in parts else {}
    if "dataset" in parts:
        selector["dataset"] = parts["dataset"].text()
    runs = [_read_run(run) for run in parts["runs"].sequence()] if "runs" in parts else ["median"]
    figure = Figure(parts["title"].text(), parts["rows"].text(), parts["columns"].text(), selector,
                    runs)
    configs = study.select(selector)
    if not configs:
        entry.fail("selects no configuration of the study")
    if len(figure.grid(study)[2]) < len(configs):
        entry.fail("has more than one configuration at a place; 'dataset' and 'where: {AXIS: VALUE}' "
                   "choose one")
    return figure


def _read_run(entry: Entry) -> str:
    if entry.text() not in RUNS:
        entry.fail(f"expected {' or '.join(RUNS)}, found {entry.found()}")
    return entry.text()
