# SPDX-License-Identifier: BSD-3-Clause
"""A tour between random places of a floor plan, by the shortest ways around its walls."""
import heapq
import itertools
import math
import pathlib

import numpy as np
import scipy.ndimage

from floor_plan import FloorPlan, distance_to

CELL_M = 0.2
CLEARANCE_M = 0.45  # from the robot's center to what it must not touch

Cell = tuple[int, int]
_STEPS = [step for step in itertools.product((-1, 0, 1), repeat=2) if step != (0, 0)]


class NoTourError(Exception):
    """There is nowhere to drive."""


def free_cells(plan: FloorPlan, size_m: tuple[float, float]) -> np.ndarray:
    """Where the robot can be, [x, y], of the largest part in which each place is reached from all."""
    x, y = np.meshgrid(*(CELL_M * np.arange(int(length / CELL_M) + 1) for length in size_m),
                       indexing="ij")
    free = distance_to(plan.outline, x, y) < -CLEARANCE_M
    for wall in plan.walls:
        free &= distance_to(wall, x, y) > CLEARANCE_M
    for disc_x, disc_y, radius in plan.discs:
        free &= np.hypot(x - disc_x, y - disc_y) > radius + CLEARANCE_M
    parts, number = scipy.ndimage.label(free, structure=np.ones((3, 3)))
    if number == 0:
        raise NoTourError("expected a place for the robot, found none in the building")
    return parts == 1 + np.argmax(np.bincount(parts.ravel())[1:])


def draw_tour(free: np.ndarray, length_m: float, rng: np.random.Generator) -> np.ndarray:
    """Way points [x, y] in m from random place to random place, until the tour is that long."""
    places = np.argwhere(free)
    if len(places) < 100:
        raise NoTourError("expected 4 square meters to drive on, found less")
    cells: list[Cell] = [_draw(places, rng)]
    length = 0.0
    while length < length_m:
        way = _shortest_way(free, cells[-1], _draw(places, rng))
        for cell in _straightened(free, way)[1:]:
            length += CELL_M * math.dist(cells[-1], cell)
            cells.append(cell)
    return CELL_M * np.array(cells)


def _draw(places: np.ndarray, rng: np.random.Generator) -> Cell:
    x, y = places[rng.integers(len(places))]
    return int(x), int(y)


def _shortest_way(free: np.ndarray, start: Cell, goal: Cell) -> list[Cell]:
    """By A*, over neighbors that touch by an edge or a corner."""
    length, before = {start: 0.0}, {start: start}
    queue = [(math.dist(start, goal), start)]
    while queue[0][1] != goal:
        _, (x, y) = heapq.heappop(queue)
        for dx, dy in _STEPS:
            cell = x + dx, y + dy
            to_cell = length[x, y] + math.hypot(dx, dy)
            if free[cell] and to_cell < length.get(cell, math.inf):
                length[cell], before[cell] = to_cell, (x, y)
                heapq.heappush(queue, (to_cell + math.dist(cell, goal), cell))
    way = [goal]
    while way[-1] != start:
        way.append(before[way[-1]])
    return way[::-1]


def _straightened(free: np.ndarray, way: list[Cell]) -> list[Cell]:
    """The way with only the corners left that walls ask for."""
    corners, k = [way[0]], 0
    while k + 1 < len(way):
        end = len(way) - 1
        while end > k + 1 and not _line_is_free(free, way[k], way[end]):
            end -= 1
        corners.append(way[end])
        k = end
    return corners


def _line_is_free(free: np.ndarray, a: Cell, b: Cell) -> bool:
    number = 4 * max(abs(a[0] - b[0]), abs(a[1] - b[1])) + 1
    x, y = (np.rint(np.linspace(a[i], b[i], number)).astype(int) for i in (0, 1))
    return bool(free[x, y].all())


def write_tour(file: pathlib.Path, points: np.ndarray) -> None:
    """A file of way points of `simulate`."""
    file.write_text("way_points:\n" + "".join(f"  - [{x:.2f}, {y:.2f}]\n" for x, y in points))
