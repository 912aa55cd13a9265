# SPDX-License-Identifier: BSD-3-Clause
"""A floor plan: walls and pillars in a rectangle, placed in a world at any angle."""
from __future__ import annotations

import dataclasses
import math
import pathlib

import numpy as np

Wall = tuple[float, float, float, float, float]  # from end to end x1, y1, x2, y2 and its thickness
Disc = tuple[float, float, float]  # x, y and the radius

CELL_M = 0.025  # of the world's raster: walls at an angle have steps of this


@dataclasses.dataclass
class FloorPlan:
    """Shapes in m. `outline` is the rectangle that the robot may not leave, as thick as it is high."""
    outline: Wall
    walls: list[Wall] = dataclasses.field(default_factory=list)
    discs: list[Disc] = dataclasses.field(default_factory=list)

    def add_box(self, x_min: float, y_min: float, x_max: float, y_max: float) -> None:
        """Leaves out what is thinner than two cells."""
        if min(x_max - x_min, y_max - y_min) >= 2 * CELL_M:
            self.walls.append(box(x_min, y_min, x_max, y_max))

    def placed(self, angle_rad: float) -> tuple[FloorPlan, tuple[float, float]]:
        """The plan turned and moved into a world whose lower left corner is the origin, and the size
        of that world."""
        c, s = math.cos(angle_rad), math.sin(angle_rad)
        turn = np.array([[c, -s], [s, c]])
        corners = np.array(corners_of(self.outline)) @ turn.T
        low, high = corners.min(axis=0), corners.max(axis=0)

        def point(x: float, y: float) -> tuple[float, float]:
            moved = turn @ [x, y] - low
            return float(moved[0]), float(moved[1])

        def wall(w: Wall) -> Wall:
            return *point(w[0], w[1]), *point(w[2], w[3]), w[4]

        return FloorPlan(wall(self.outline), [wall(w) for w in self.walls],
                         [(*point(x, y), radius) for x, y, radius in self.discs]), \
            (float(high[0] - low[0]), float(high[1] - low[1]))


def box(x_min: float, y_min: float, x_max: float, y_max: float) -> Wall:
    """The rectangle as a wall from left to right."""
    y = (y_min + y_max) / 2
    return x_min, y, x_max, y, y_max - y_min


def room(width_m: float, height_m: float, thickness_m: float) -> FloorPlan:
    """An empty plan with its corner at the origin; without outer walls if their thickness is 0."""
    plan = FloorPlan(box(0, 0, width_m, height_m))
    t = thickness_m
    plan.add_box(0, 0, width_m, t)
    plan.add_box(0, height_m - t, width_m, height_m)
    plan.add_box(0, t, t, height_m - t)
    plan.add_box(width_m - t, t, width_m, height_m - t)
    return plan


def corners_of(wall: Wall) -> list[tuple[float, float]]:
    x1, y1, x2, y2, thickness = wall
    length = math.hypot(x2 - x1, y2 - y1)
    nx, ny = -(y2 - y1) / length * thickness / 2, (x2 - x1) / length * thickness / 2
    return [(x1 + nx, y1 + ny), (x1 - nx, y1 - ny), (x2 - nx, y2 - ny), (x2 + nx, y2 + ny)]


def distance_to(wall: Wall, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """From each point to the edge of the wall; below 0 inside of it."""
    x1, y1, x2, y2, thickness = wall
    length = math.hypot(x2 - x1, y2 - y1)
    ux, uy = (x2 - x1) / length, (y2 - y1) / length
    dx, dy = x - (x1 + x2) / 2, y - (y1 + y2) / 2
    along = np.abs(dx * ux + dy * uy) - length / 2
    across = np.abs(dy * ux - dx * uy) - thickness / 2
    return (np.hypot(np.maximum(along, 0), np.maximum(across, 0))
            + np.minimum(np.maximum(along, across), 0))


def write_world(file: pathlib.Path, plan: FloorPlan, size_m: tuple[float, float]) -> None:
    """A world file of `simulate`."""
    def items(name: str, shapes: list) -> list[str]:
        lines = [f"  - [{', '.join(f'{number:.3f}' for number in shape)}]" for shape in shapes]
        return [f"{name}:", *lines] if lines else []

    width, height = size_m
    file.write_text("\n".join([
        f"size: [{width:.3f}, {height:.3f}]", f"resolution: {CELL_M}", *items("walls", plan.walls),
        *items("discs", plan.discs)]) + "\n")
