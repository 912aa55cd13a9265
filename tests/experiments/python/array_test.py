# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in and out: nothing is copied that need not be, and what is given comes back."""

import tracemalloc
import unittest

import numpy as np
import room

import gmapping_spa as gs


class RangesTest(unittest.TestCase):
    def test_float_arrays_are_read_where_they_lie(self):
        for dtype in (np.float32, np.float64):
            ranges = np.full(100_000, 2.5, dtype)
            tracemalloc.start()
            gs.LaserScan(0.0, ranges)
            _, peak = tracemalloc.get_traced_memory()  # numpy reports its arrays to it
            tracemalloc.stop()
            self.assertLess(peak, 20_000, dtype)
        tracemalloc.start()
        gs.LaserScan(0.0, np.full(100_000, 2, np.int16))
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        self.assertGreater(peak, 700_000)  # what is converted is seen

    def test_strides_and_types_do_not_matter(self):
        ranges = np.linspace(1, 9, 50)
        expected = gs.LaserScan(0.0, ranges).beams.tolist()
        wide = np.zeros((50, 3))
        wide[:, 1] = ranges
        record = np.zeros(50, [("byte", "u1"), ("range", "f8")])
        record["range"] = ranges
        for same in (wide[:, 1], record["range"], ranges[::-1].copy()[::-1], ranges.astype(">f8"),
                     list(ranges)):
            self.assertEqual(gs.LaserScan(0.0, same).beams.tolist(), expected)
        single = gs.LaserScan(0.0, ranges.astype(np.float32)).beams["range_m"]
        np.testing.assert_array_equal(single, ranges.astype(np.float32).astype(float))

    def test_beams_say_what_ranges_say(self):
        scan = gs.LaserScan(1.0, [1.0, np.nan, -1, 0.01, 40, np.inf], angle_min_rad=-0.5,
                            angle_step_rad=0.25, odom_T_robot=(1, 2, 3))
        hit, none, bad = gs.BeamStatus.HIT, gs.BeamStatus.NO_RETURN, gs.BeamStatus.INVALID
        self.assertEqual(scan.beams["status"].tolist(), [hit, bad, bad, bad, none, none])
        self.assertEqual(scan.beams["range_m"].tolist(), [1, 0, 0, 0, 40, 40])
        self.assertEqual(scan.beams["angle_rad"].tolist(), [-0.5, -0.25, 0, 0.25, 0.5, 0.75])
        self.assertEqual(scan.odom_T_robot.tolist(), [1, 2, 3])
        self.assertIsNone(gs.LaserScan(1.0, [1.0]).odom_T_robot)

    def test_views_outlive_what_they_view(self):
        beams = gs.LaserScan(0.0, np.full(5, 3.0)).beams
        nodes = room.square_graph().nodes
        self.assertEqual(beams["range_m"].tolist(), [3] * 5)
        self.assertEqual(nodes["id"].tolist(), [10, 20, 30, 40])
        with self.assertRaises(ValueError):
            beams["range_m"] = 1


class MapTest(unittest.TestCase):
    def test_comes_back_from_its_files(self):
        import tempfile

        world = room.world()
        with tempfile.TemporaryDirectory() as folder:
            world.write(f"{folder}/map.yaml")
            read = gs.read_map(f"{folder}/map.yaml")
        np.testing.assert_array_equal(read.cells, world.cells)
        self.assertEqual(read.extent_m, world.extent_m)
        self.assertEqual(read.resolution_m, 0.05)

    def test_row_0_is_at_the_bottom(self):
        cells = np.full((2, 3), -1)
        cells[0, 2] = 100
        tiny = gs.OccupancyMap(cells, 0.5, origin_x_m=1, origin_y_m=2)
        self.assertEqual(tiny.cells.tolist(), [[-1, -1, 100], [-1, -1, -1]])
        self.assertEqual(tiny.extent_m, (1, 2.5, 2, 3))


if __name__ == "__main__":
    unittest.main()
