# SPDX-License-Identifier: BSD-3-Clause
"""Tours go around walls by short ways, keep clear of them, and are as long as asked."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "experiments" / "stress"))

import tour
from floor_plan import distance_to, room


def two_rooms():
    """10 m x 6 m, with a wall from below that leaves 1.5 m above."""
    plan = room(10, 6, 0.2)
    plan.add_box(5, 0.2, 5.2, 4.3)
    plan.discs.append((8.0, 3.0, 0.5))
    return plan


class TourTest(unittest.TestCase):
    def setUp(self):
        self.plan = two_rooms()
        self.free = tour.free_cells(self.plan, (10, 6))

    def is_free(self, x, y):
        return self.free[round(x / tour.CELL_M), round(y / tour.CELL_M)]

    def test_free_is_what_is_clear_of_walls_discs_and_the_outline(self):
        self.assertTrue(self.is_free(2, 2) and self.is_free(5, 5))
        for x, y in ((0.4, 3), (5.6, 2), (8, 3), (8.8, 3), (10, 6)):
            self.assertFalse(self.is_free(x, y), (x, y))

    def test_only_the_largest_part_is_free(self):
        self.plan.add_box(5, 4.3, 5.2, 5.8)  # nothing is open now
        free = tour.free_cells(self.plan, (10, 6))
        parts = [free[:25].any(), free[27:].any()]
        self.assertEqual(sum(parts), 1)

    def test_the_tour_keeps_clear_and_is_long_enough(self):
        points = tour.draw_tour(self.free, 80, np.random.default_rng(4))
        steps = np.hypot(*np.diff(points, axis=0).T)
        self.assertTrue(80 <= steps.sum() < 100)
        self.assertGreater(steps.min(), 0)
        for a, b in zip(points, points[1:]):
            x, y = np.linspace(a, b, 50).T
            for wall in self.plan.walls:
                self.assertGreater(distance_to(wall, x, y).min(), tour.CLEARANCE_M - tour.CELL_M)

    def test_ways_are_short_and_straight(self):
        way = tour._straightened(self.free, tour._shortest_way(self.free, (10, 5), (40, 5)))
        self.assertTrue(3 <= len(way) <= 7, way)
        corner_y = max(y for _, y in way) * tour.CELL_M
        self.assertTrue(4.7 < corner_y < 5.1)
        self.assertEqual(tour._straightened(self.free, tour._shortest_way(
            self.free, (5, 5), (5, 20))), [(5, 5), (5, 20)])

    def test_nowhere_to_drive_is_an_error(self):
        with self.assertRaisesRegex(tour.NoTourError, "expected a place for the robot, found none"):
            tour.free_cells(room(0.8, 6, 0.2), (0.8, 6))
        with self.assertRaisesRegex(tour.NoTourError, "expected 4 square meters"):
            tour.draw_tour(tour.free_cells(room(2, 2, 0.2), (2, 2)), 10, np.random.default_rng(1))

    def test_the_file_is_what_simulate_reads(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "tour.yaml"
            tour.write_tour(file, np.array([[1.0, 2.0], [3.4, 2.0]]))
            self.assertEqual(yaml.safe_load(file.read_text()), {"way_points": [[1, 2], [3.4, 2]]})


if __name__ == "__main__":
    unittest.main()
