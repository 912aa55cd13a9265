# SPDX-License-Identifier: BSD-3-Clause
"""Metrics and the simulator."""

import pathlib
import tempfile
import unittest

import numpy as np
import room

import gmapping_spa as gs


class MetricsTest(unittest.TestCase):
    def test_a_moved_trajectory_has_no_error_once_aligned(self):
        truth = room.run().truth
        moved = truth.copy()
        moved["world_T_robot"] += (3, 4, 0)
        errors = gs.absolute_trajectory_error(truth, moved)
        self.assertEqual(errors.pairs, len(truth))
        self.assertAlmostEqual(errors.translation_m.max, 0, places=9)
        errors = gs.absolute_trajectory_error(truth, moved, alignment="none")
        self.assertAlmostEqual(errors.translation_m.mean, 5, places=9)
        self.assertAlmostEqual(gs.relative_pose_error(truth, moved).translation_m.max, 0, places=9)

    def test_relations_of_the_truth_have_no_error(self):
        truth = room.run().truth
        relation = gs.Relation(truth["stamp_s"][0], truth["stamp_s"][-1], (1, 0, 0))
        x, y, theta = truth["world_T_robot"][0]
        end = truth["world_T_robot"][-1]
        c, s = np.cos(theta), np.sin(theta)
        true_x = c * (end[0] - x) + s * (end[1] - y)
        true_y = -s * (end[0] - x) + c * (end[1] - y)
        errors = gs.evaluate_relations([relation], truth)
        self.assertEqual((errors.used, errors.not_associated), (1, 0))
        self.assertAlmostEqual(errors.translation_m.mean, np.hypot(true_x - 1, true_y))
        with self.assertRaises(RuntimeError):
            gs.evaluate_relations([gs.Relation(1e9, 2e9, (0, 0, 0))], truth)

    def test_files_come_back(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "new" / "truth.tum"
            gs.write_tum(path, room.run().truth)
            np.testing.assert_array_equal(gs.read_tum(path), room.run().truth)
            relations = pathlib.Path(folder) / "relations"
            relations.write_text("1 2 3 4 0 0 0 0.5\n")
            self.assertEqual(gs.read_relations(relations)[0].i_T_j.tolist(), [3, 4, 0.5])
            relations.write_text("1 2 3\n")
            with self.assertRaisesRegex(RuntimeError, "relations:1: expected"):
                gs.read_relations(relations)


class SimulatorTest(unittest.TestCase):
    def test_the_same_arguments_give_the_same_run(self):
        again = gs.simulate(room.world(), room.TOUR, beams=180, max_range_m=12, scan_rate_hz=5,
                            seed=3)
        np.testing.assert_array_equal(again.truth, room.run().truth)
        for a, b in zip(again.scans, room.run().scans):
            np.testing.assert_array_equal(a.beams, b.beams)
        self.assertGreater(again.path_length_m, 20)

    def test_a_robot_that_would_touch_something_is_an_error(self):
        with self.assertRaises(RuntimeError):
            gs.simulate(room.world(), [(2, 4), (8, 4)])
        for wrong in ([(2, 2)], [(2, 2), (2, 2)], [(2, 2), (np.nan, 2)], "text", [1, 2]):
            with self.assertRaises(ValueError):
                gs.simulate(room.world(), wrong)


if __name__ == "__main__":
    unittest.main()
