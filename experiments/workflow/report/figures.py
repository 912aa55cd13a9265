# SPDX-License-Identifier: BSD-3-Clause
"""The figures that a study asks for as files of their own: PNG, for READMEs, papers and slides."""
import io
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot

from . import maps

PANEL_WIDTH = 3.4  # inches
DPI = 150


def figures(measured, scores):
    """(file name, PNG) of each figure and of its error maps."""
    if measured.study.figures:
        for gallery in maps.galleries(measured, scores):
            name = re.sub(r"[^a-z0-9]+", "_", gallery.title.lower()).strip("_")
            yield f"{measured.study.name}_{name}.png", draw(gallery)


def draw(gallery):
    """Panels in rows and columns with their names; the same bytes for the same panels."""
    pictures = [[pyplot.imread(io.BytesIO(panel.png)) if panel.png else None for panel in panels]
                for _, panels in gallery.rows]
    height = PANEL_WIDTH * max((p.shape[0] / p.shape[1] for row in pictures for p in row
                                if p is not None), default=1.0)
    figure, axes = pyplot.subplots(
        len(gallery.rows), len(gallery.columns), squeeze=False, layout="constrained",
        figsize=(PANEL_WIDTH * len(gallery.columns), (height + 0.25) * len(gallery.rows)))
    for (name, _), row, places in zip(gallery.rows, pictures, axes):
        for picture, place in zip(row, places):
            place.set(xticks=[], yticks=[])
            place.set_frame_on(False)
            if picture is not None:
                place.imshow(picture, interpolation="none")
        places[0].set_ylabel(name)
    for column, place in zip(gallery.columns, axes[0]):
        place.set_title(column)
    out = io.BytesIO()
    figure.savefig(out, format="png", dpi=DPI, metadata={"Software": None})
    pyplot.close(figure)
    return out.getvalue()
