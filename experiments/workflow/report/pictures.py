# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of maps, small enough to stand side by side in a page: PNG with a palette."""
import dataclasses
import io

import numpy
import yaml
from PIL import Image

WIDTH = 560  # pixels, at most
# Unknown, free, occupied: where cells are merged the last one wins, so that no wall is lost.
MAP_COLORS = [(205, 205, 205), (255, 255, 255), (0, 0, 0)]
# As evaluate_map draws them: in sight, never in sight, cells of the map at the boundary, boundary
# that the map has, boundary that it misses, cells of the map off the boundary.
ERROR_COLORS = [(255, 255, 255), (217, 217, 217), (140, 140, 140), (0, 0, 0), (0, 115, 179),
                (214, 94, 0)]
ERROR_LEGEND_HEIGHT = 40  # pixels


@dataclasses.dataclass(frozen=True)
class MapImage:
    """Cells 0 unknown, 1 free, 2 occupied; the first row is the highest y."""
    cells: numpy.ndarray
    resolution_m: float
    x_m: float  # of the lower left corner
    y_m: float

    def known_box(self):
        """x_min, y_min, x_max, y_max in m of the known cells, None if there are none."""
        rows, columns = numpy.nonzero(self.cells)
        if len(rows) == 0:
            return None
        top = self.y_m + len(self.cells) * self.resolution_m
        return (self.x_m + columns.min() * self.resolution_m,
                top - (rows.max() + 1) * self.resolution_m,
                self.x_m + (columns.max() + 1) * self.resolution_m,
                top - rows.min() * self.resolution_m)

    def window(self, box):
        """The cells in the box, unknown where the map does not reach."""
        x_min, y_min, x_max, y_max = box
        height, width = (round((high - low) / self.resolution_m)
                         for low, high in ((y_min, y_max), (x_min, x_max)))
        top = self.y_m + len(self.cells) * self.resolution_m
        row = round((top - y_max) / self.resolution_m)
        column = round((x_min - self.x_m) / self.resolution_m)
        window = numpy.zeros((height, width), dtype=numpy.uint8)
        r0, c0 = max(0, row), max(0, column)
        part = self.cells[r0:max(r0, row + height), c0:max(c0, column + width)]
        window[r0 - row:r0 - row + part.shape[0], c0 - column:c0 - column + part.shape[1]] = part
        return window


def read_map(yaml_file):
    """A map as map_server keeps it."""
    about = yaml.safe_load(yaml_file.read_text())
    gray = numpy.asarray(Image.open(yaml_file.parent / about["image"]).convert("L"))
    occupancy = gray / 255.0 if about["negate"] else 1.0 - gray / 255.0
    cells = numpy.zeros(gray.shape, dtype=numpy.uint8)
    cells[occupancy < about["free_thresh"]] = 1
    cells[occupancy > about["occupied_thresh"]] = 2
    return MapImage(cells, about["resolution"], *about["origin"][:2])


def common_box(maps):
    """The smallest box around what any of the maps knows, None if none knows anything."""
    boxes = [box for box in (m.known_box() for m in maps) if box]
    if not boxes:
        return None
    low, high = numpy.min(boxes, axis=0), numpy.max(boxes, axis=0)
    return float(low[0]), float(low[1]), float(high[2]), float(high[3])


def map_png(cells):
    return indexed_png(cells, MAP_COLORS)


def error_png(file):
    """evaluate_map's picture of errors without the legend below it, which would be too small."""
    pixels = numpy.asarray(Image.open(file).convert("RGB"))[:-ERROR_LEGEND_HEIGHT]
    # Millions of pixels have few colors.
    packed = pixels.astype(numpy.uint32) @ numpy.array([1 << 16, 1 << 8, 1], numpy.uint32)
    found, index = numpy.unique(packed, return_inverse=True)
    channels = (found[:, None] >> numpy.array([16, 8, 0], numpy.uint32) & 255).astype(int)
    distances = [numpy.abs(channels - color).sum(axis=1) for color in ERROR_COLORS]
    nearest = numpy.argmin(distances, axis=0)
    return indexed_png(nearest[index].reshape(packed.shape), ERROR_COLORS)


def indexed_png(indices, colors):
    """At most WIDTH wide: blocks are merged, their highest index wins."""
    factor = -(-indices.shape[1] // WIDTH)
    rows, columns = (-(-size // factor) * factor for size in indices.shape)
    padded = numpy.zeros((rows, columns), dtype=numpy.uint8)
    padded[:indices.shape[0], :indices.shape[1]] = indices
    merged = padded.reshape(rows // factor, factor, columns // factor, factor).max(axis=(1, 3))
    image = Image.fromarray(merged, mode="P")
    image.putpalette([channel for color in colors for channel in color])
    out = io.BytesIO()
    image.save(out, format="PNG", optimize=True, bits=max(1, (len(colors) - 1).bit_length()))
    return out.getvalue()
