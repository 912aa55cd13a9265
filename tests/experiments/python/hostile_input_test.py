# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that are none raise; the interpreter goes on, and so does a Slam."""

import unittest

import numpy as np
import room

import gmapping_spa as gs


class ScanTest(unittest.TestCase):
    def test_ranges_that_are_none(self):
        for wrong in (
            np.zeros((3, 3)), np.zeros(()), 5, "text", None, [[1, 2], [3]], np.zeros(3, complex),
            np.array(["a", "b"]), np.array([object(), 1]), np.zeros(3, bool),
            np.zeros(3, [("range", "f8")]), {1: 2}, np.zeros(1_000_001, np.float32),
        ):
            with self.assertRaises(ValueError, msg=repr(wrong)[:50]):
                gs.LaserScan(0.0, wrong)

    def test_numbers_that_are_none(self):
        nan = float("nan")
        for keywords in (
            {"odom_T_robot": (1, 2)}, {"odom_T_robot": (1, 2, nan)}, {"odom_T_robot": "abc"},
            {"robot_T_laser": (1e9, 0, 0)}, {"robot_T_laser": None}, {"angle_min_rad": 0.0},
            {"angle_min_rad": nan, "angle_step_rad": 0.1},
            {"angle_min_rad": 0, "angle_step_rad": 1e300}, {"range_min_m": -1},
            {"range_min_m": 50}, {"usable_range_m": nan}, {"usable_range_m": 1e300},
        ):
            with self.assertRaises(ValueError, msg=keywords):
                gs.LaserScan(0.0, np.ones(4), **keywords)
        for stamp in (nan, float("inf")):
            with self.assertRaises(ValueError):
                gs.LaserScan(stamp, np.ones(4))
        with self.assertRaises(TypeError):
            gs.LaserScan("now", np.ones(4))


class SlamTest(unittest.TestCase):
    def test_calls_that_make_no_sense_change_nothing(self):
        run = room.run()
        slam, twin = gs.Slam(), gs.Slam()
        for ask in (lambda: slam.pose, lambda: slam.map, lambda: slam.graph,
                    lambda: slam.trajectory, slam.finish):
            with self.assertRaises(RuntimeError):
                ask()
        for scan in run.scans[:20]:
            slam.add_scan(scan)
            twin.add_scan(scan)
            with self.assertRaisesRegex(ValueError, "order of time"):
                slam.add_scan(gs.LaserScan(scan.stamp_s - 1, np.ones(4)))
            with self.assertRaisesRegex(ValueError, "beams within"):
                slam.add_scan(gs.LaserScan(scan.stamp_s, [5000.0], usable_range_m=9000))
            for wrong in (None, 5, np.ones(180), run):
                with self.assertRaises(TypeError):
                    slam.add_scan(wrong)
        np.testing.assert_array_equal(slam.trajectory, twin.trajectory)

    def test_scans_of_changing_sizes(self):
        generator = np.random.default_rng(1)
        slam = gs.Slam(gs.SlamOptions(particles=2))
        for k, scan in enumerate(room.run().scans[:100]):
            size = (0, 1, 2, 5, 180, 361, 1081)[k % 7]
            ranges = generator.uniform(-1, 15, size).astype((np.float32, np.float64)[k % 2])
            ranges[generator.random(size) < 0.1] = np.nan
            slam.add_scan(gs.LaserScan(scan.stamp_s, ranges, odom_T_robot=scan.odom_T_robot))
        slam.finish()
        self.assertEqual(len(slam.trajectory), 100)

    def test_scans_without_a_beam(self):
        slam = gs.Slam()
        for k in range(30):
            slam.add_scan(gs.LaserScan(k / 10, [], odom_T_robot=(k, 0, 0)))
        slam.finish()
        self.assertEqual(slam.map.cells.size, 0)
        with self.assertRaisesRegex(ValueError, "empty"):
            slam.map.write("/tmp/never.yaml")

    def test_odometry_that_leads_out_of_all_maps(self):
        for odometry in ("raw", "wheel", "lidar"):
            slam = gs.Slam(gs.SlamOptions(odometry=odometry))
            try:
                for k in range(20):
                    slam.add_scan(gs.LaserScan(float(k), np.full(90, 5.0),
                                               odom_T_robot=(10.0 ** k, -(10.0 ** k), k)))
            except RuntimeError as error:
                self.assertIn("out of the area", str(error))

    def test_many_scans_of_one_stamp(self):
        slam = gs.Slam()
        for _ in range(20):
            slam.add_scan(gs.LaserScan(1.0, np.full(90, 5.0), odom_T_robot=(0, 0, 0)))
        self.assertEqual(len(slam.trajectory), 20)

    def test_a_very_fine_and_a_very_coarse_map(self):
        for resolution_m in (0.005, 10.0):
            slam = gs.Slam(gs.SlamOptions(resolution_m=resolution_m, particles=1))
            for scan in room.run().scans[:12]:
                slam.add_scan(scan)

    def test_options_that_are_none(self):
        for wrong, error in (
            ({"particles": 0}, ValueError), ({"particles": -5}, ValueError),
            ({"resolution_m": float("nan")}, ValueError), ({"particles": "many"}, TypeError),
            ({"odometry": "sonar"}, ValueError), ({"loss": "sonar"}, ValueError),
            ({"particels": 5}, TypeError), ({"copy": 5}, (TypeError, AttributeError)),
            ({"backend": "sonar"}, RuntimeError), ({"settings": {"a": "b"}}, RuntimeError),
            ({"seed": -1}, TypeError),
        ):
            with self.assertRaises(error, msg=wrong):
                gs.Slam(gs.SlamOptions(**wrong))
        for wrong in (5, object(), type("No", (), {"optimize": 5})()):
            with self.assertRaisesRegex(ValueError, "optimize"):
                gs.Slam(backend=wrong)


class GraphTest(unittest.TestCase):
    def test_graphs_that_are_none(self):
        good = room.square_graph()
        nodes, edges = good.nodes.copy(), good.edges.copy()
        for field, row, value in (
            ("id", 0, 20), ("world_T_node", 1, (np.nan, 0, 0)), ("stamp_s", 2, np.inf)
        ):
            bad = nodes.copy()
            bad[field][row] = value
            with self.assertRaises(ValueError, msg=field):
                gs.PoseGraph(bad, edges)
        for field, row, value in (
            ("i", 0, 99), ("i_T_j", 1, (0, np.inf, 0)), ("kind", 2, 7),
            ("information", 0, [[1, 2, 0], [0, 1, 0], [0, 0, 1]]), ("information", 0, np.nan),
        ):
            bad = edges.copy()
            bad[field][row] = value
            with self.assertRaises(ValueError, msg=field):
                gs.PoseGraph(nodes, bad)
        for bad in (None, 5, "text", nodes["id"], np.zeros((2, 2)), [], nodes.reshape(2, 2), edges):
            with self.assertRaises(ValueError):
                gs.PoseGraph(bad, edges)

    def test_views_that_were_spoiled_are_found_when_used(self):
        graph = room.square_graph()
        graph.nodes["world_T_node"][2] = np.nan
        for use in (gs.optimize, gs.covariances, gs.certify,
                    lambda g: gs.write_g2o("/tmp/never.g2o", g)):
            with self.assertRaises(ValueError):
                use(graph)

    def test_an_empty_graph(self):
        empty = gs.PoseGraph(np.zeros(0, gs.NODE_DTYPE), np.zeros(0, gs.EDGE_DTYPE))
        self.assertEqual(len(gs.optimize(empty)[0].nodes), 0)
        self.assertEqual(gs.covariances(empty).shape, (0, 3, 3))

    def test_fields_in_another_layout_do(self):
        graph = room.square_graph()
        packed = np.zeros(4, [("world_T_node", "f4", 3), ("id", "i4"), ("fixed", "?"),
                              ("stamp_s", "f8"), ("more", "u1")])
        for name in graph.nodes.dtype.names:
            packed[name] = graph.nodes[name]
        again = gs.PoseGraph(packed, graph.edges)
        np.testing.assert_allclose(again.nodes["world_T_node"], graph.nodes["world_T_node"],
                                   rtol=1e-6)

    def test_options_that_are_none(self):
        for keywords in ({"loss": "sonar"}, {"init": "sonar"}, {"loss_scale": 0},
                         {"max_iterations": -1}, {"cost_tolerance": float("nan")},
                         {"max_solver_time_s": 0}):
            with self.assertRaises(ValueError, msg=keywords):
                gs.optimize(room.square_graph(), **keywords)
        with self.assertRaises(RuntimeError):
            gs.optimize(room.square_graph(), "sonar")
        with self.assertRaises(RuntimeError):
            gs.optimize(room.square_graph(), settings={"none": "1"})


class MapAndMetricsTest(unittest.TestCase):
    def test_maps_that_are_none(self):
        for cells in (np.zeros(3, int), np.zeros((2, 2)), np.full((2, 2), 50), "text", None):
            with self.assertRaises(ValueError):
                gs.OccupancyMap(cells, 0.05)
        for resolution_m in (0, -1, float("nan"), float("inf")):
            with self.assertRaises(ValueError):
                gs.OccupancyMap(np.zeros((2, 2), int), resolution_m)

    def test_trajectories_that_are_none(self):
        truth = room.run().truth
        spoiled = truth.copy()
        spoiled["stamp_s"][3] = np.nan
        for bad in (spoiled, truth["world_T_robot"], None, 5, truth[0]):
            with self.assertRaises(ValueError):
                gs.absolute_trajectory_error(truth, bad)
        with self.assertRaises(RuntimeError):
            gs.absolute_trajectory_error(truth, truth[:0])
        for step in (0, -1, float("nan")):
            with self.assertRaises(ValueError):
                gs.relative_pose_error(truth, truth, step=step)
        with self.assertRaises(ValueError):
            gs.absolute_trajectory_error(truth, truth, alignment="sonar")


if __name__ == "__main__":
    unittest.main()
