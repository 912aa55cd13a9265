# SPDX-License-Identifier: BSD-3-Clause
"""Offices: rooms that do not overlap, none too small, and a door in every wall between them."""
import pathlib
import sys
import unittest

import numpy as np
import scipy.ndimage

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "experiments" / "stress"))

import office_plan
from floor_plan import distance_to, room


def split(seed, width=30.0, height=20.0):
    plan = room(width, height, 0.2)
    builder = office_plan._Builder(np.random.default_rng(seed), plan, 0.2, smallest_m=3.5, door_m=1.4)
    builder.split((0.2, 0.2, width - 0.2, height - 0.2), 0)
    return builder


class OfficePlanTest(unittest.TestCase):
    def test_rooms_do_not_overlap_and_only_corridors_are_narrow(self):
        for seed in range(20):
            rooms = np.array(split(seed).rooms)
            self.assertGreater(len(rooms), 4)
            sizes = np.minimum(rooms[:, 2] - rooms[:, 0], rooms[:, 3] - rooms[:, 1])
            self.assertGreaterEqual(sizes.min(), 1.8)
            self.assertLessEqual(((sizes < 3.5) & (sizes > 3)).sum(), 0)
            for i, a in enumerate(rooms):
                for b in rooms[i + 1:]:
                    apart = (max(a[0], b[0]) >= min(a[2], b[2]) - 1e-9
                             or max(a[1], b[1]) >= min(a[3], b[3]) - 1e-9)
                    self.assertTrue(apart, (seed, a, b))

    def test_no_wall_is_without_a_door(self):
        for seed in range(5):
            plan = split(seed).plan
            x, y = np.meshgrid(np.arange(0, 30, 0.2), np.arange(0, 20, 0.2), indexing="ij")
            free = np.logical_and.reduce([distance_to(wall, x, y) > 0 for wall in plan.walls])
            inner = free[2:-2, 2:-2]
            parts, number = scipy.ndimage.label(inner)
            # A wall that meets a door may leave a closed corner, never most of the building.
            self.assertGreater(np.bincount(parts.ravel())[1:].max() / inner.sum(), 0.7, (seed, number))

    def test_things_leave_room_to_pass(self):
        plan = room(6, 6, 0.2)
        office_plan._furnish(plan, (0.2, 0.2, 5.8, 5.8), 3, np.random.default_rng(1))
        self.assertGreater(len(plan.walls), 4)
        small = room(3, 3, 0.2)
        office_plan._furnish(small, (0.2, 0.2, 2.5, 2.5), 30, np.random.default_rng(1))
        self.assertEqual(len(small.walls), 4)


if __name__ == "__main__":
    unittest.main()
