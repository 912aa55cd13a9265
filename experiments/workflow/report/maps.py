"""Maps side by side: in rows and columns as the study's figures say, else one after the other."""
import dataclasses

from . import median_run, pictures, selection
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
    for title, log, columns, rows in _layouts(measured):
        runs = {id(cell): _median_result(measured, cell) for _, cells in rows for cell in cells}
        rule = median_run.rule(measured, log)
        yield Gallery(title, f"{MAPS} {rule}", columns, _map_rows(rows, runs, measured))
        errors = {key: scores / f"{r.run.id}.error_map.png" for key, r in runs.items() if r}
        if any(file.exists() for file in errors.values()):
            yield Gallery(f"{title}: error maps", ERRORS, columns, [
                (name, [_error_panel(cell, runs, errors) for cell in cells])
                for name, cells in rows])


def _layouts(measured):
    """(title, log, names of columns, [(name of row, cells)]); None where there is no cell."""
    study = measured.study
    for figure in study.figures:
        rows, columns, cells = figure.grid(study)
        log = next(iter(cells.values())).log
        yield (figure.title, log, [selection.label({figure.columns: c}) for c in columns],
               [(selection.label({figure.rows: r}), [cells.get((r, c)) for c in columns])
                for r in rows])
    if not study.figures:
        for log in measured.logs():
            yield f"Maps, log {log}", log, [], [("", [c for c in study.cells if c.log == log])]


def _median_result(measured, cell):
    seed = median_run.median_seed(measured, cell) if cell else None
    return None if seed is None else measured.result(cell, seed)


def _map_rows(rows, runs, measured):
    maps = {key: pictures.read_map(result.folder / "map.yaml")
            for key, result in runs.items() if result and not result.failed()}
    box = pictures.common_box(maps.values())

    def panel(cell):
        result = runs[id(cell)]
        if id(cell) not in maps or box is None:
            return _no_picture(cell, result)
        metric = measured.main_metric(cell.log)
        value = measured.values(cell, metric)[result.run.seed] if metric else None
        shown = "" if value is None else f": {heading(metric)} {value:.3g}"
        return Panel(f"{selection.label_within_log(cell)}, seed {result.run.seed}{shown}",
                     f"Map of {cell.label()}, seed {result.run.seed}",
                     pictures.map_png(maps[id(cell)].window(box)))

    return [(name, [panel(cell) for cell in cells]) for name, cells in rows]


def _error_panel(cell, runs, files):
    result = runs[id(cell)]
    file = files.get(id(cell))
    if file is None or not file.exists():
        return _no_picture(cell, result)
    return Panel(f"{selection.label_within_log(cell)}, seed {result.run.seed}",
                 f"Errors of the map of {cell.label()}, seed {result.run.seed}",
                 pictures.error_png(file))


def _no_picture(cell, result):
    if cell is None:
        return Panel("not part of the study", "", None)
    if result is None:
        return Panel(f"{selection.label_within_log(cell)}: runs are missing", "", None)
    return Panel(f"{selection.label_within_log(cell)}, seed {result.run.seed}: the median run "
                 f"{'failed' if result.failed() else 'has no picture'}", "", None)
