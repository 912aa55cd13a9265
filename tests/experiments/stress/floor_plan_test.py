# SPDX-License-Identifier: BSD-3-Clause
"""Plans keep their shapes at any angle, and distances to walls are those of rectangles."""
import math
import pathlib
import sys
import tempfile
import unittest

import numpy as np
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "experiments" / "stress"))

import floor_plan


class FloorPlanTest(unittest.TestCase):
    def test_a_box_is_a_wall_with_the_same_corners(self):
        corners = floor_plan.corners_of(floor_plan.box(1, 2, 4, 3))
        self.assertEqual(set(corners), {(1, 2), (4, 2), (4, 3), (1, 3)})

    def test_what_is_thinner_than_two_cells_is_left_out(self):
        plan = floor_plan.room(5, 4, 0)
        self.assertEqual(plan.walls, [])
        plan.add_box(1, 1, 1.04, 3)
        self.assertEqual(plan.walls, [])
        plan.add_box(1, 1, 1.05, 3)
        self.assertEqual(len(plan.walls), 1)

    def test_distances_are_to_the_edge_and_negative_inside(self):
        wall = floor_plan.box(0, 0, 4, 2)
        x, y = np.array([5.0, 2.0, 7.0, 2.0, 0.5]), np.array([1.0, 5.0, 6.0, 1.0, 1.0])
        np.testing.assert_allclose(floor_plan.distance_to(wall, x, y), [1, 3, 5, -1, -0.5])

    def test_a_turned_plan_has_the_same_distances_and_lies_in_its_world(self):
        plan = floor_plan.room(6, 3, 0.2)
        plan.discs.append((2.0, 1.0, 0.3))
        for angle_rad in (0.0, 0.7, 2.0, 4.0):
            turned, (width, height) = plan.placed(angle_rad)
            corners = np.array(floor_plan.corners_of(turned.outline))
            np.testing.assert_allclose(corners.min(axis=0), 0, atol=1e-9)
            np.testing.assert_allclose(corners.max(axis=0), [width, height])
            [(x, y, radius)] = turned.discs
            self.assertEqual(radius, 0.3)
            for before, after in zip([plan.outline, *plan.walls], [turned.outline, *turned.walls]):
                self.assertAlmostEqual(float(floor_plan.distance_to(before, 2.0, 1.0)),
                                       float(floor_plan.distance_to(after, x, y)))
        _, size = plan.placed(math.pi / 2)
        np.testing.assert_allclose(size, (3, 6))

    def test_the_world_file_has_all_shapes(self):
        plan = floor_plan.room(6, 3, 0.2)
        plan.discs.append((2.0, 1.0, 0.3))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "world.yaml"
            floor_plan.write_world(file, plan, (6, 3))
            world = yaml.safe_load(file.read_text())
        self.assertEqual(world["size"], [6, 3])
        self.assertEqual(world["walls"][0], [0, 0.1, 6, 0.1, 0.2])
        self.assertEqual((len(world["walls"]), world["discs"]), (4, [[2, 1, 0.3]]))


if __name__ == "__main__":
    unittest.main()
