# SPDX-License-Identifier: BSD-3-Clause
"""What stresses share: odometry that is set everywhere alike, stretches that do not meet."""
import unittest

import numpy as np
import stress_test_case

import carmen
import poses
import registry


class RegistryTest(stress_test_case.StressTestCase):
    def test_every_kind_says_what_it_does(self):
        import stresses
        self.assertGreater(len(stresses.STRESSES), 25)
        for stress in stresses.STRESSES.values():
            self.assertGreater(len(stress.meaning), 10)

    def test_the_laser_and_odom_records_follow_the_robot(self):
        log = self.before
        old = registry.odometry_of(log.scans())
        old_odom = np.array([r.odom_T_robot for r in log.odometry()])
        shift = np.array([10.0, -4.0, 1.5])
        registry.set_odometry(log, poses.compose(shift, old))
        np.testing.assert_allclose(registry.odometry_of(log.scans()), poses.compose(shift, old))
        for scan in log.scans():
            np.testing.assert_allclose(poses.between(scan.odom_T_robot, scan.odom_T_laser),
                                       [0.2, 0, 0], atol=3e-6)
        np.testing.assert_allclose([r.odom_T_robot for r in log.odometry()],
                                   poses.compose(shift, old_odom), atol=1e-9)

    def test_stretches_do_not_meet_and_are_where_the_robot_moves(self):
        scans = self.before.scans()
        for scan in scans[:150]:
            scan.odom_T_robot = np.array(scans[150].odom_T_robot)  # stands
        for seed in range(5):
            found = registry.moving_stretches(scans, np.random.default_rng(seed), 4, 1.0)
            self.assertEqual(len(found), 4)
            for (_, last), (first, _) in zip(found, found[1:]):
                self.assertLess(last + 1, first)
            for first, last in found:
                self.assertGreaterEqual(first, 140)
                self.assertIn(last - first, (9, 10))

    def test_a_log_without_room_for_a_stress_is_refused(self):
        self.before.keep(self.before.scans()[:9])
        with self.assertRaisesRegex(carmen.LogError, "too short"):
            registry.moving_stretches(self.before.scans(), np.random.default_rng(1), 4, 1.0)


if __name__ == "__main__":
    unittest.main()
