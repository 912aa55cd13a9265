# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of random buildings by name; office_plan.py has the one that is more than a few lines."""
import dataclasses
import math
from collections.abc import Callable

import numpy as np

from floor_plan import FloorPlan, room
from office_plan import office

Draw = Callable[[np.random.Generator], FloorPlan]


@dataclasses.dataclass(frozen=True)
class Kind:
    draw: Draw
    meaning: str
    least_range_m: float  # of a laser that sees something most of the time


def corridors(rng: np.random.Generator) -> FloorPlan:
    """one to three long corridors side by side, joined at both ends, with doors at regular distances,
    some of them closed"""
    number, pitch, depth = int(rng.integers(1, 4)), rng.uniform(2.5, 5), rng.uniform(3, 5)
    width, thickness, door = rng.uniform(1.7, 2.6), 0.1, 1.5
    length = pitch * int(rng.integers(8, 18))
    joint = width if number > 1 else 0.0  # of the corridors across, at both ends
    plan = room(length + 2 * joint, number * width + (number + 1) * depth, thickness)
    closed = rng.choice([0.2, 0.6, 0.9])
    for k in range(number + 1):
        low, high = k * (depth + width), k * (depth + width) + depth
        for x in np.arange(joint, joint + length + pitch / 2, pitch):
            plan.add_box(x - thickness / 2, low, x + thickness / 2, high)
        for y in ([low] if k > 0 else []) + ([high - thickness] if k < number else []):
            if joint and k in (0, number):  # along the corridors across
                plan.add_box(0, y, joint, y + thickness)
                plan.add_box(joint + length, y, length + 2 * joint, y + thickness)
            for x in np.arange(joint, joint + length - pitch / 2, pitch):
                left, right = x + pitch / 2 - door / 2, x + pitch / 2 + door / 2
                plan.add_box(x, y, left, y + thickness)
                plan.add_box(right, y, x + pitch, y + thickness)
                if rng.random() < closed:  # set back on both sides
                    plan.add_box(left, y + 0.02, right, y + thickness - 0.02)
    return plan


def hall(rng: np.random.Generator) -> FloorPlan:
    """one open hall with pillars at regular distances and a few things that stand about"""
    width, height, pitch = rng.uniform(20, 50), rng.uniform(15, 40), rng.uniform(4, 10)
    plan = room(width, height, 0.2)
    half, is_round = rng.uniform(0.15, 0.4), rng.random() < 0.5
    for x in np.arange(pitch, width - 2, pitch):
        for y in np.arange(pitch, height - 2, pitch):
            if is_round:
                plan.discs.append((float(x), float(y), half))
            else:
                plan.add_box(x - half, y - half, x + half, y + half)
    for _ in range(rng.poisson(rng.choice([0, 4, 12]))):
        x, y = rng.uniform(2, width - 4), rng.uniform(2, height - 4)
        w, h = rng.uniform(0.4, 2.0, 2)
        plan.add_box(x, y, x + w, y + h)
    return plan


def yard(rng: np.random.Generator) -> FloorPlan:
    """an open area without walls around: houses, trees, and cars at any angle"""
    width, height = rng.uniform(30, 60, 2)
    plan = room(width, height, 0)
    for _ in range(rng.integers(1, 5)):
        w, h = rng.uniform(4, 14, 2)
        x, y = rng.uniform(0, width - w), rng.uniform(0, height - h)
        plan.add_box(x, y, x + w, y + h)
    for _ in range(rng.integers(10, 60)):
        plan.discs.append((float(rng.uniform(0, width)), float(rng.uniform(0, height)),
                           float(rng.uniform(0.1, 0.4))))
    for _ in range(rng.integers(0, 12)):
        x, y, angle = rng.uniform(3, width - 3), rng.uniform(3, height - 3), rng.uniform(0, math.pi)
        dx, dy = 2.2 * math.cos(angle), 2.2 * math.sin(angle)
        plan.walls.append((x - dx, y - dy, x + dx, y + dy, 1.8))
    return plan


KINDS: dict[str, Kind] = {
    draw.__name__: Kind(draw, " ".join((draw.__doc__ or "").split()), least_range_m)
    for draw, least_range_m in ((office, 4), (corridors, 4), (hall, 8), (yard, 12))}
