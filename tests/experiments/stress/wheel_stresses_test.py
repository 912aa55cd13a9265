# SPDX-License-Identifier: BSD-3-Clause
"""Wheels go wrong by what each kind says, and the scans stay as they are."""
import unittest

import numpy as np
import stress_test_case

import poses
import registry

KINDS = ["yawjump", "jump", "silent", "late", "reset", "encoder_wrap", "first_garbage", "drop",
         "scale", "feet", "noisy", "wheel_bias", "yaw_drift"]


class WheelStressesTest(stress_test_case.StressTestCase):
    def setUp(self):
        super().setUp()
        self.true = registry.odometry_of(self.before.scans())

    def odometry(self, kind, **how):
        return registry.odometry_of(self.stressed(kind, **how).scans())

    def errors_of_steps(self, kind, **how):
        """What each step of the wheels has too much, in the frame of the robot after it."""
        return poses.between(poses.steps_of(self.true), poses.steps_of(self.odometry(kind, **how)))

    def test_scans_and_stamps_stay(self):
        for kind in KINDS:
            with self.subTest(kind):
                self.assert_scans_untouched(self.stressed(kind))
                self.assertGreater(np.abs(self.odometry(kind) - self.true).max(), 1e-3)

    def test_the_seed_decides(self):
        for kind in ("yawjump", "jump", "reset", "drop", "noisy"):
            np.testing.assert_array_equal(self.odometry(kind), self.odometry(kind))
            self.assertTrue(np.any(self.odometry(kind) != self.odometry(kind, seed=2)), kind)

    def test_yawjump_turns_twenty_steps(self):
        errors = self.errors_of_steps("yawjump")
        wrong = np.degrees(np.abs(errors[:, 2])) > 0.01
        self.assertEqual(wrong.sum(), 20)
        self.assertTrue(np.all(np.degrees(np.abs(errors[wrong, 2])) > 14.9))
        self.assertTrue(np.all(np.degrees(np.abs(errors[wrong, 2])) < 60.1))
        np.testing.assert_allclose(errors[:, :2], 0.0, atol=1e-9)
        half = np.abs(self.errors_of_steps("yawjump", size=0.5)[wrong, 2])
        np.testing.assert_allclose(half, np.abs(errors[wrong, 2]) / 2)

    def test_jump_displaces_ten_steps(self):
        errors = self.errors_of_steps("jump")
        length = np.hypot(errors[:, 0], errors[:, 1])
        self.assertEqual((length > 1e-6).sum(), 10)
        np.testing.assert_allclose(length[length > 1e-6], 0.5)
        np.testing.assert_allclose(np.abs(errors[length > 1e-6, 2]), np.radians(30))

    def test_silent_wheels_say_zero_in_every_record(self):
        log = self.stressed("silent")
        np.testing.assert_array_equal(registry.odometry_of(log.scans()), 0.0)
        np.testing.assert_array_equal([r.odom_T_robot for r in log.odometry()], 0.0)
        self.assertEqual({tuple(r.speeds) for r in log.odometry()}, {("0", "0", "0")})

    def test_late_odometry_is_that_of_the_time_before(self):
        late = self.odometry("late")
        np.testing.assert_allclose(late[10], stress_test_case.pose_of(8.5), atol=1e-3)
        np.testing.assert_array_equal(late[0], self.true[0])

    def test_reset_restarts_at_zero_in_the_middle_third(self):
        odometry = self.odometry("reset")
        at = np.flatnonzero(np.all(np.abs(odometry) < 1e-9, axis=1))
        self.assertEqual(len(at), 1)
        self.assertTrue(100 <= at[0] <= 200)
        errors = self.errors_of_steps("reset")
        self.assertEqual((np.abs(errors).max(axis=1) > 1e-6).sum(), 1)

    def test_a_counter_that_wraps_moves_x_alone(self):
        moved = self.odometry("encoder_wrap") - self.true
        np.testing.assert_allclose(np.unique(np.round(moved[:, 0], 6)), [-65.536, 0.0])
        np.testing.assert_allclose(moved[:, 1:], 0.0, atol=1e-9)

    def test_garbage_ends_after_three_readings(self):
        odometry = self.odometry("first_garbage")
        self.assertTrue(np.all(np.abs(odometry[:3, :2]) > 900))
        np.testing.assert_allclose(odometry[3:], self.true[3:])

    def test_dropped_readings_come_all_at_once(self):
        odometry = self.odometry("drop")
        silent = np.flatnonzero(np.all(np.abs(poses.steps_of(odometry)) < 1e-9, axis=1))
        self.assertEqual(len(silent), 5 * 4)
        right = np.all(np.isclose(odometry, self.true), axis=1)
        self.assertEqual((~right).sum(), 5 * 4)

    def test_scale_and_bias_are_those_of_the_wheels(self):
        steps, true_steps = poses.steps_of(self.odometry("scale")), poses.steps_of(self.true)
        np.testing.assert_allclose(steps, 1.05 * true_steps, atol=1e-9)
        feet = poses.steps_of(self.odometry("feet"))
        np.testing.assert_allclose(feet * [0.3048, 0.3048, 1.0], true_steps, atol=1e-9)
        bias = poses.steps_of(self.odometry("wheel_bias")) - true_steps
        right_wheel = true_steps[:, 0] + 0.2 * true_steps[:, 2]
        np.testing.assert_allclose(bias[:, 2], 0.02 * right_wheel / 0.4, atol=1e-9)
        np.testing.assert_allclose(bias[:, 0], 0.01 * right_wheel, atol=1e-9)

    def test_noise_is_a_fifth_of_the_motion(self):
        error = poses.steps_of(self.odometry("noisy")) - poses.steps_of(self.true)
        self.assertAlmostEqual(np.std(error[:, 0]), 0.02, delta=0.004)
        self.assertAlmostEqual(np.std(error[:, 2]), 0.004, delta=0.001)

    def test_heading_drifts_while_the_robot_moves(self):
        errors = self.errors_of_steps("yaw_drift")
        np.testing.assert_allclose(errors[:, 2], np.radians(0.05), rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
