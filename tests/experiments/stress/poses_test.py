# SPDX-License-Identifier: BSD-3-Clause
"""Poses compose, invert and chain as motions in the plane do."""
import unittest

import numpy as np
import stress_test_case  # noqa: F401

import poses

A, B = np.array([1.0, 2.0, np.pi / 2]), np.array([0.5, -1.0, 3.0])


class PosesTest(unittest.TestCase):
    def test_the_second_pose_is_seen_from_the_first(self):
        np.testing.assert_allclose(poses.compose(A, B), [2.0, 2.5, np.pi / 2 + 3 - 2 * np.pi])

    def test_between_undoes_compose(self):
        np.testing.assert_allclose(poses.between(A, poses.compose(A, B)), B)
        np.testing.assert_allclose(poses.compose(A, poses.inverse(A)), np.zeros(3), atol=1e-15)

    def test_steps_chain_to_the_same_poses(self):
        walk = np.random.default_rng(1).uniform(-3, 3, (50, 3))
        np.testing.assert_allclose(poses.chain(walk[0], poses.steps_of(walk)), walk, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
