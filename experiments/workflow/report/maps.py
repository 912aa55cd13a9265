# SPDX-License-Identifier: BSD-3-Clause
"""Maps side by side: in rows and columns as the study's figures say, else one after the other."""
import dataclasses

from study import Configuration

from . import pictures, selection, shown_run
from .tables import heading


@dataclasses.dataclass(frozen=True)
class Panel:
    """png is None where there is no picture; then text says why."""
    text: str
    alt: str
    png: bytes | None


@dataclasses.dataclass(frozen=True)
class Gallery:
    """Panels by row; the names of rows and columns are empty where there is no such layout."""
    title: str
    caption: str
    columns: list
    rows: list  # (name, panels)


MAPS = "White is free, black occupied, grey unknown. All maps have the same scale and frame."
ERRORS = (
    "The errors of the same runs' maps. Black is true boundary that the map has, blue true "
    "boundary that it misses; dark grey are occupied cells at the boundary, orange those off it. White was "
    "in sight, light grey never.")


def galleries(measured, scores):
    """Of the maps, each followed by the same layout of error maps where there are some.

    scores is the folder of <run id>.error_map.png."""
    for title, dataset, columns, rows in _layouts(measured):
        runs = {place: _result(measured, place) for _, places in rows for place in places}
        with_worst = any(place.which == "worst" for place in runs)
        rule = shown_run.rule(measured, dataset, with_worst)
        yield Gallery(title, f"{MAPS} {rule}", columns, _map_rows(rows, runs, measured))
        errors = {place: scores / f"{r.run.id}.error_map.png" for place, r in runs.items() if r}
        if any(file.exists() for file in errors.values()):
            yield Gallery(f"{title}: error maps", ERRORS, columns, [
                (name, [_error_panel(place, runs, errors) for place in places])
                for name, places in rows])


@dataclasses.dataclass(frozen=True, eq=False)
class _Place:
    """What a panel shows: `configuration` is None where there is none, `which` is a name of shown_run."""
    configuration: Configuration | None
    which: str


def _layouts(measured):
    """(title, dataset, names of columns, [(name of row, places)])."""
    study = measured.study
    for figure in study.figures:
        rows, columns, configs = figure.grid(study)
        dataset = next(iter(configs.values())).dataset
        yield (figure.title, dataset,
               [_column(figure, c, which) for c in columns for which in figure.runs],
               [(selection.label({figure.rows: r}),
                 [_Place(configs.get((r, c)), which) for c in columns for which in figure.runs])
                for r in rows])
    if not study.figures:
        for dataset in measured.datasets():
            yield f"Maps, dataset {dataset}", dataset, [], [
                ("", [_Place(c, "median") for c in study.configurations if c.dataset == dataset])]


def _column(figure, value, which):
    label = selection.label({figure.columns: value})
    return label if len(figure.runs) == 1 else f"{label}, {which} run"


def _result(measured, place):
    config = place.configuration
    seed = shown_run.seed_of(measured, config, place.which) if config else None
    return None if seed is None else measured.result(config, seed)


def _map_rows(rows, runs, measured):
    maps = {place: pictures.read_map(result.folder / "map.yaml")
            for place, result in runs.items() if result and not result.failed()}
    box = pictures.common_box(maps.values())

    def panel(place):
        config, result = place.configuration, runs[place]
        if place not in maps or box is None:
            return _no_picture(place, result)
        metric = measured.main_metric(config.dataset)
        value = measured.values(config, metric)[result.run.seed] if metric else None
        shown = "" if value is None else f": {heading(metric)} {value:.3g}"
        return Panel(f"{selection.label_within_dataset(config)}, seed {result.run.seed}{shown}",
                     f"Map of {config.label()}, seed {result.run.seed}",
                     pictures.map_png(maps[place].window(box)))

    return [(name, [panel(place) for place in places]) for name, places in rows]


def _error_panel(place, runs, files):
    config, result = place.configuration, runs[place]
    file = files.get(place)
    if file is None or not file.exists():
        return _no_picture(place, result)
    return Panel(f"{selection.label_within_dataset(config)}, seed {result.run.seed}",
                 f"Errors of the map of {config.label()}, seed {result.run.seed}",
                 pictures.error_png(file))


def _no_picture(place, result):
    if place.configuration is None:
        return Panel("not part of the study", "", None)
    name = selection.label_within_dataset(place.configuration)
    if result is None:
        return Panel(f"{name}: runs are missing", "", None)
    what = "failed" if result.failed() else "has no picture"
    return Panel(f"{name}, seed {result.run.seed}: the {place.which} run {what}", "", None)
