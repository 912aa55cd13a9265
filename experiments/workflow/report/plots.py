# SPDX-License-Identifier: BSD-3-Clause
"""Plots of a metric against an axis of the study, as SVG: the same bytes for the same numbers."""
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
from matplotlib.transforms import ScaledTranslation
from metrics import METRICS, highest

from . import selection, statistics
from .tables import heading

STYLE = {
    "svg.hashsalt": "gmapping_spa", "svg.fonttype": "none", "font.family": "sans-serif",
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
    "grid.color": "#e4e4e4", "grid.linewidth": 0.6, "axes.axisbelow": True,
}
# Okabe and Ito's colours, which the colour-blind can tell apart, and markers for print in grey.
COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000")
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
COLUMNS = 3  # of panels
SHIFT_POINTS = 5  # between the lines of a panel


def plots(measured):
    """(title, description, SVG) for each axis and dataset."""
    found = []
    for axis in axes_to_plot(measured.study):
        for dataset in measured.datasets():
            names = [m for m in measured.shown_metrics() if measured.exists(dataset, m)]
            if names:
                labels = ", ".join(METRICS[name].label for name in names)
                found.append((
                    f"{labels} against {axis}, dataset {dataset}",
                    f"Lines join means, bars are their 95 % intervals (none for fewer than "
                    f"{statistics.FEW} runs), faint dots single runs. Failed runs have no dot.",
                    draw(measured, dataset, axis, names)))
    return found


def axes_to_plot(study):
    """Those with more than one value; the variants where there is no other."""
    axes = [axis for axis in study.configurations[0].axes
            if len({config.axes[axis] for config in study.configurations}) > 1]
    return axes or (["variant"] if len({c.variant for c in study.configurations}) > 1 else [])


def draw(measured, dataset, axis, names):
    columns = min(COLUMNS, len(names))
    rows = -(-len(names) // columns)
    with matplotlib.rc_context(STYLE):
        figure, panels = pyplot.subplots(
            rows, columns, figsize=(3.5 * columns, 2.7 * rows + 0.4), squeeze=False,
            layout="constrained")
        for panel in panels.flat[len(names):]:
            panel.set_visible(False)
        for name, panel in zip(names, panels.flat):
            _draw_panel(panel, measured, dataset, axis, name)
        handles, labels = panels[0, 0].get_legend_handles_labels()
        if len(labels) > 1:
            figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0),
                          ncol=min(4, len(labels)), frameon=False)
        out = io.StringIO()
        figure.savefig(out, format="svg", bbox_inches="tight", metadata={"Date": None})
        pyplot.close(figure)
    return out.getvalue()


def _draw_panel(panel, measured, dataset, axis, metric):
    configs = [config for config in measured.study.configurations if config.dataset == dataset]
    values = list(dict.fromkeys(config.coordinates()[axis] for config in configs))
    numeric = all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in values)
    if numeric:
        values.sort()
    places = dict(zip(values, values if numeric else range(len(values))))
    lines = {}
    for config in configs:
        rest = {k: v for k, v in config.coordinates().items() if k not in ("dataset", axis)}
        lines.setdefault(selection.label(rest), []).append(config)
    for k, (label, line) in enumerate(lines.items()):
        # Side by side, so that intervals of one place do not hide each other.
        shift = ScaledTranslation((k - (len(lines) - 1) / 2) * SHIFT_POINTS / 72, 0,
                                  panel.figure.dpi_scale_trans)
        style = {"color": COLORS[k % len(COLORS)], "marker": MARKERS[k % len(MARKERS)],
                 "linestyle": "solid" if numeric else "none",
                 "transform": panel.transData + shift}
        points = sorted(((places[config.coordinates()[axis]], config) for config in line),
                        key=lambda point: point[0])
        _draw_line(panel, measured, metric, label or "all", points, style)
    _set_scale(panel, values, numeric)
    panel.set_xlabel(axis)
    panel.set_title(heading(metric), loc="left", fontsize=9)


def _draw_line(panel, measured, metric, label, points, style):
    means = []
    for place, config in points:
        runs = [v for v in measured.values(config, metric).values() if v is not None]
        panel.plot([place] * len(runs), runs, alpha=0.3, markersize=3, markeredgewidth=0,
                   **{**style, "linestyle": "none"})
        summary = statistics.summarize(runs, 0.0, highest(metric))
        if runs:
            below, above = (0.0, 0.0) if summary.low is None else (
                summary.mean - summary.low, summary.high - summary.mean)
            means.append((place, summary.mean, below, above))
    x, y, below, above = zip(*means) if means else ((), (), (), ())
    panel.errorbar(x, y, yerr=[below, above], label=label, capsize=2.5, linewidth=1.4,
                   elinewidth=1, markersize=4.5, **style)


def _set_scale(panel, values, numeric):
    panel.margins(0.08)
    if not numeric:
        panel.set_xticks(range(len(values)), [str(v) for v in values], rotation=20, ha="right")
        panel.margins(x=0.2)
        return
    if min(values) > 0 and max(values) >= 6 * min(values):
        panel.set_xscale("log")
    panel.set_xticks(values, [f"{v:g}" for v in values])
    panel.minorticks_off()
