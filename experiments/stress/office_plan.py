# SPDX-License-Identifier: BSD-3-Clause
"""Offices: a rectangle split into rooms and corridors until the rooms are small."""
import dataclasses

import numpy as np

from floor_plan import FloorPlan, room

MOST_SPLITS = 6
ROOM_TO_PASS_M = 1.1  # beside whatever stands in a room

Area = tuple[float, float, float, float]  # x_min, y_min, x_max, y_max


def office(rng: np.random.Generator) -> FloorPlan:
    """rooms along corridors, with doors in all walls, and things in the rooms"""
    width, height = rng.uniform(15, 50), rng.uniform(12, 40)
    thickness = float(rng.choice([0.1, 0.15, 0.2, 0.3]))
    builder = _Builder(rng, room(width, height, thickness), thickness,
                       smallest_m=rng.uniform(3, 7), door_m=rng.uniform(1.4, 1.8))
    builder.split((thickness, thickness, width - thickness, height - thickness), 0)
    things_in_30_m2 = rng.choice([0, 0.5, 1.5, 3])
    for area in builder.rooms:
        _furnish(builder.plan, area, things_in_30_m2, rng)
    return builder.plan


@dataclasses.dataclass
class _Builder:
    rng: np.random.Generator
    plan: FloorPlan
    thickness_m: float
    smallest_m: float  # width of a room
    door_m: float
    rooms: list[Area] = dataclasses.field(default_factory=list)

    def split(self, area: Area, depth: int) -> None:
        x_min, y_min, x_max, y_max = area
        width, height = x_max - x_min, y_max - y_min
        least = 2 * self.smallest_m + self.thickness_m
        is_done = depth > 2 and self.rng.random() < 0.12
        if depth > MOST_SPLITS or max(width, height) < least or is_done:
            self.rooms.append(area)
            return
        upright = width > height if abs(width - height) > 2 else self.rng.random() < 0.5
        if (width if upright else height) < least:
            upright = not upright
        low, high = (x_min, x_max) if upright else (y_min, y_max)
        between = self.thickness_m  # the two halves: a wall, or a corridor with its two walls
        corridor_m = self.rng.uniform(1.8, 3)
        if depth < 2 and self.rng.random() < 0.7 and high - low > least + corridor_m + between:
            between += corridor_m + self.thickness_m
        at = self.rng.uniform(low + self.smallest_m, high - self.smallest_m - between)
        self._wall(upright, at, area)
        if between > self.thickness_m:
            last = at + between - self.thickness_m
            self._wall(upright, last, area)
            self.rooms.append(_part(area, upright, at + self.thickness_m, last))
        self.split(_part(area, upright, low, at), depth + 1)
        self.split(_part(area, upright, at + between, high), depth + 1)

    def _wall(self, upright: bool, at: float, area: Area) -> None:
        """Across the area, with one to three doors; two may meet to a wide one."""
        low, high = (area[1], area[3]) if upright else (area[0], area[2])
        number = 1 + int(self.rng.random() < 0.35) + int(high - low > 12)
        begin = low
        for door in sorted(self.rng.uniform(low + 0.3, high - 0.3 - self.door_m, number)):
            self._piece(upright, at, begin, door)
            begin = door + self.door_m
        self._piece(upright, at, begin, high)

    def _piece(self, upright: bool, at: float, begin: float, end: float) -> None:
        across = at + self.thickness_m
        self.plan.add_box(*((at, begin, across, end) if upright else (begin, at, end, across)))


def _part(area: Area, upright: bool, low: float, high: float) -> Area:
    x_min, y_min, x_max, y_max = area
    return (low, y_min, high, y_max) if upright else (x_min, low, x_max, high)


def _furnish(plan: FloorPlan, area: Area, things_in_30_m2: float, rng: np.random.Generator) -> None:
    x_min, y_min, x_max, y_max = area
    size = (x_max - x_min) * (y_max - y_min) / 30
    for _ in range(rng.poisson(things_in_30_m2 * min(size, 3))):
        width, height = rng.uniform(0.3, 1.6, 2)
        if x_max - x_min < width + 2 * ROOM_TO_PASS_M or y_max - y_min < height + 2 * ROOM_TO_PASS_M:
            continue
        x = rng.uniform(x_min, x_max - width)
        y = y_min if rng.random() < 0.5 else y_max - height  # at a wall
        if rng.random() < 0.4:
            x = rng.uniform(x_min + 0.5, x_max - width - 0.5)
            y = rng.uniform(y_min + 0.5, y_max - height - 0.5)
        plan.add_box(x, y, x + width, y + height)
