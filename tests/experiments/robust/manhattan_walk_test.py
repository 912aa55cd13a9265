#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
import math
import pathlib
import random
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "experiments/robust"))
import manhattan_walk


class ManhattanWalk(unittest.TestCase):
    def test_stays_in_the_city_and_closes_loops_where_it_was_before(self):
        truth, closures = manhattan_walk.walk(3000, 12, 0.5)
        self.assertEqual(len(truth), 3000)
        self.assertLessEqual(max(max(abs(x), abs(y)) for x, y, _ in truth), 12)
        self.assertGreater(len(closures), 500)
        for i, j in closures:
            self.assertEqual(truth[i][:2], truth[j][:2])
            self.assertGreater(j - i, 10)
        for a, b in zip(truth, truth[1:]):
            self.assertEqual(abs(a[0] - b[0]) + abs(a[1] - b[1]), 1)

    def test_measures_with_the_noise_that_the_graph_says(self):
        truth = [(3, 1, 1), (1, 2, 0)]  # 2 m to the left and 1 m ahead, turned by -90 degrees
        draw = random.Random(1)
        found = [manhattan_walk.measure(truth, 0, 1, draw) for _ in range(2000)]
        for k, (mean, sigma) in enumerate(((1, manhattan_walk.SIGMA_M), (2, manhattan_walk.SIGMA_M),
                                           (-math.pi / 2, manhattan_walk.SIGMA_RAD))):
            errors = [pose[k] - mean for pose in found]
            self.assertLess(abs(sum(errors) / 2000), 4 * sigma / math.sqrt(2000))
            self.assertLess(abs(sum(e * e for e in errors) / 2000 / sigma ** 2 - 1), 0.15)

    def test_writes_the_odometry_as_poses(self):
        truth, closures = manhattan_walk.walk(200, 5, 0.5)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "walk.g2o"
            manhattan_walk.write_graph(path, truth, closures)
            lines = [line.split() for line in path.read_text().splitlines()]
        vertices = [line for line in lines if line[0] == "VERTEX_SE2"]
        edges = [line for line in lines if line[0] == "EDGE_SE2"]
        self.assertEqual((len(vertices), len(edges)), (200, 199 + len(closures)))
        for a, b, edge in zip(vertices, vertices[1:], edges):
            x, y, theta = map(float, a[2:])
            dx, dy = map(float, edge[3:5])
            self.assertAlmostEqual(float(b[2]), x + math.cos(theta) * dx - math.sin(theta) * dy, 4)
            self.assertAlmostEqual(float(b[3]), y + math.sin(theta) * dx + math.cos(theta) * dy, 4)


if __name__ == "__main__":
    unittest.main()
