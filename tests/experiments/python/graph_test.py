# SPDX-License-Identifier: BSD-3-Clause
"""Pose graphs as arrays, and any back end on them."""

import logging
import pathlib
import tempfile
import unittest

import numpy as np
import room

import gmapping_spa as gs


class Descent:
    """A back end in Python: Gauss-Newton with numeric Jacobians."""

    def optimize(self, nodes, edges):
        free = np.flatnonzero(~nodes["fixed"])
        row = {node: k for k, node in enumerate(nodes["id"])}
        poses = nodes["world_T_node"].copy()

        def errors(step):
            moved = poses.copy()
            moved[free] += step.reshape(-1, 3)
            result = []
            for edge in edges:
                a, b = moved[row[edge["i"]]], moved[row[edge["j"]]]
                c, s = np.cos(a[2]), np.sin(a[2])
                dx, dy = b[:2] - a[:2]
                error = np.array([c * dx + s * dy, -s * dx + c * dy, b[2] - a[2]]) - edge["i_T_j"]
                error[2] = (error[2] + np.pi) % (2 * np.pi) - np.pi
                result.append(np.linalg.cholesky(edge["information"]).T @ error)
            return np.concatenate(result)

        for _ in range(10):
            zero = np.zeros(3 * len(free))
            jacobian = np.stack(
                [(errors(h) - errors(-h)) / 2e-6 for h in 1e-6 * np.eye(len(zero))], axis=1)
            poses[free] += np.linalg.lstsq(jacobian, -errors(zero), rcond=None)[0].reshape(-1, 3)
        return poses


class OptimizeTest(unittest.TestCase):
    def test_back_ends_agree_and_leave_the_graph_as_it_was(self):
        graph = room.square_graph()
        before = graph.nodes.copy()
        names = [b["name"] for b in gs.list_backends() if b["loadable"] and b["name"] != "none"]
        self.assertIn("spa", names)
        spa, summary = gs.optimize(graph, loss="none")
        self.assertTrue(summary.converged)
        self.assertLess(summary.final_cost, 0.3 * summary.initial_cost)
        for back_end in (*names, Descent()):
            optimized, _ = gs.optimize(graph, back_end, loss="none")
            np.testing.assert_allclose(optimized.nodes["world_T_node"], spa.nodes["world_T_node"],
                                       atol=1e-4)
        np.testing.assert_array_equal(graph.nodes, before)

    def test_a_back_end_may_change_nodes_in_place(self):
        class InPlace:
            def optimize(self, nodes, edges):
                nodes["world_T_node"][:] = Descent().optimize(nodes, edges)

        _, summary = gs.optimize(room.square_graph(), InPlace(), loss="none")
        self.assertLess(summary.final_cost, 0.3 * summary.initial_cost)

    def test_the_default_loss_needs_one_that_the_back_end_has(self):
        with self.assertLogs("gmapping_spa", logging.WARNING) as said:
            gs.optimize(room.square_graph(), Descent())
        self.assertIn("dcs", said.output[0])
        with self.assertRaisesRegex(RuntimeError, "does not support the loss huber"):
            gs.optimize(room.square_graph(), Descent(), loss="huber")

        class Robust(Descent):
            losses = ["huber", "dcs"]

            def optimize(self, nodes, edges, loss, loss_scale):
                self.seen = loss, loss_scale

        robust = Robust()
        gs.optimize(room.square_graph(), robust, loss="huber", loss_scale=2)
        self.assertEqual(robust.seen, ("huber", 2.0))

    def test_what_a_back_end_raises_is_the_cause(self):
        class Broken:
            def optimize(self, nodes, edges):
                raise KeyError("lost")

        with self.assertRaisesRegex(RuntimeError, "the back end failed: .*KeyError") as caught:
            gs.optimize(room.square_graph(), Broken(), loss="none")
        self.assertIsInstance(caught.exception.__cause__, KeyError)

        class Stopped:
            def optimize(self, nodes, edges):
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            gs.optimize(room.square_graph(), Stopped(), loss="none")

    def test_garbage_is_a_failure(self):
        poses = room.square_graph().nodes["world_T_node"]
        for garbage, message in (
            (5, "shape"), ("text", "shape"), (poses[:2], "shape"), (poses[:, :2], "shape"),
            (poses + np.nan, "finite"), (poses + 1j, "shape"), ([object()] * 4, "shape"),
            (poses + np.arange(12).reshape(4, 3), "cost"), (np.zeros((0, 3)), "shape"),
        ):
            back_end = type("Garbage", (), {"optimize": lambda self, n, e, g=garbage: g})()
            with self.assertRaisesRegex(RuntimeError, message):
                gs.optimize(room.square_graph(), back_end, loss="none")

    def test_fixed_nodes_stay_whatever_a_back_end_returns(self):
        back_end = type("Mover", (), {"optimize": lambda self, n, e: n["world_T_node"] + 7})()
        with self.assertRaisesRegex(RuntimeError, "cost"):
            gs.optimize(room.square_graph(), back_end, loss="none")


class AccuracyTest(unittest.TestCase):
    def test_covariances_are_those_of_the_graph(self):
        graph, summary = gs.optimize(room.square_graph())
        every = gs.covariances(graph, summary=summary)
        self.assertEqual(every.shape, (4, 3, 3))
        np.testing.assert_array_equal(every[0], np.zeros((3, 3)))
        self.assertTrue((np.linalg.eigvalsh(every[1:]) > 0).all())
        np.testing.assert_allclose(gs.covariances(graph, [30], summary), every[2:3])
        np.testing.assert_allclose(gs.covariances(graph, [[30, 30]], summary), every[2:3])
        with self.assertRaisesRegex(ValueError, "no node 31"):
            gs.covariances(graph, [31])

    def test_the_optimum_is_proved_and_other_poses_are_not(self):
        graph, _ = gs.optimize(room.square_graph(), loss="none")
        self.assertTrue(gs.certify(graph)[1].optimal)
        self.assertFalse(gs.certify(room.square_graph())[1].optimal)
        self.assertTrue(gs.certify(room.square_graph(), descend=True)[1].optimal)


class FileTest(unittest.TestCase):
    def test_graphs_come_back_to_the_bit(self):
        graph = room.square_graph()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "graph.g2o"
            gs.write_g2o(path, graph)
            read = gs.read_g2o(str(path))
        np.testing.assert_array_equal(read.nodes["world_T_node"], graph.nodes["world_T_node"])
        np.testing.assert_array_equal(read.edges, graph.edges)

    def test_errors_have_file_and_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "bad.g2o"
            path.write_text("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 x 0 0\n")
            with self.assertRaisesRegex(RuntimeError, r"bad\.g2o:2: "):
                gs.read_g2o(path)
            with self.assertRaisesRegex(RuntimeError, "No such file"):
                gs.read_g2o(f"{folder}/none.g2o")
            with self.assertRaises(RuntimeError):
                gs.write_g2o("/proc/none/graph.g2o", room.square_graph())

    def test_what_is_left_out_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "loop.g2o"
            path.write_text("VERTEX_SE2 0 0 0 0\nEDGE_SE2 0 0 1 0 0 1 0 0 1 0 1\n")
            with self.assertLogs("gmapping_spa", logging.WARNING):
                gs.read_g2o(path)
            with self.assertRaises(RuntimeError):
                gs.read_g2o(path, strict=True)


if __name__ == "__main__":
    unittest.main()
