# SPDX-License-Identifier: BSD-3-Clause
"""Beams get worse by what each kind says, and the wheels stay as they are."""
import unittest

import numpy as np
import stress_test_case
from stress_test_case import NO_RETURN_M

import carmen
import poses


class BeamStressesTest(stress_test_case.StressTestCase):
    def ranges(self, log):
        return np.array([scan.ranges_m for scan in log.scans()])

    def setUp(self):
        super().setUp()
        self.true = self.ranges(self.before)

    def assert_only_lost(self, kind):
        """Which beams give nothing back; all others must be as they were."""
        log = self.stressed(kind)
        self.assert_odometry_untouched(log)
        ranges = self.ranges(log)
        lost = (ranges != self.true)
        np.testing.assert_array_equal(ranges[lost], NO_RETURN_M)
        return lost

    def test_the_middle_of_the_view_is_left(self):
        lost = self.assert_only_lost("fov90")
        np.testing.assert_array_equal(np.flatnonzero(~lost[0]), [*range(45, 136), 180])

    def test_what_is_far_is_not_seen(self):
        np.testing.assert_array_equal(self.assert_only_lost("range8"),
                                      (self.true > 8) & (self.true < 40))
        np.testing.assert_array_equal(self.assert_only_lost("range5_6"),
                                      (self.true > 5.6) & (self.true < 40))

    def test_a_scan_that_knows_its_maximum_range_says_no_return_by_it(self):
        for scan in self.before.scans():
            scan.beams = ["0", "-1.57", "3.14", "0.01745", "30.0", "0.01", "0"]
            scan.speeds = ["0"] * 5
        carmen.write(self.before, self.file)
        self.assertEqual(set(self.ranges(self.stressed("range8"))[0, 150:180]), {30.0})

    def test_a_maximum_range_that_is_not_said_is_a_reading(self):
        ranges = self.ranges(self.stressed("unsaid_maximum"))
        np.testing.assert_array_equal(ranges, np.minimum(self.true, 8.0))

    def test_parts_of_the_robot_are_where_they_are_in_every_scan(self):
        log = self.stressed("robot_parts")
        self.assert_odometry_untouched(log)
        ranges = self.ranges(log)
        on_robot = np.arange(ranges.shape[1]) % 45 < 10
        np.testing.assert_array_equal(ranges[:, ~on_robot], self.true[:, ~on_robot])
        np.testing.assert_allclose(ranges[:, on_robot], 0.4, atol=0.06)

    def test_noise_leaves_no_returns_alone(self):
        error = self.ranges(self.stressed("range_noise")) - self.true
        np.testing.assert_array_equal(error[:, -1], 0.0)
        self.assertAlmostEqual(np.std(error[:, :-1]), 0.05, delta=0.001)

    def test_a_tenth_of_the_beams_and_some_bursts_are_lost(self):
        lost = self.assert_only_lost("dropouts")[:, :-1]
        self.assertAlmostEqual(lost.mean(), 0.1 + 0.1 * 20 / 180, delta=0.02)
        bursts = [np.all(row[i:i + 10]) for row in lost for i in range(0, 170, 10)]
        self.assertGreater(sum(bursts), 5)

    def test_glass_stays_in_its_place_while_the_robot_turns(self):
        lost = self.assert_only_lost("glass")
        self.assertGreater(lost.mean(), 0.02)
        self.assertLess(lost.mean(), 0.5)
        # From scan to scan the robot turns by 1.1 deg: hidden beams shift by one, hardly more.
        edges = [np.flatnonzero(a[:-1] != b[1:]) for a, b in zip(lost, lost[1:])]
        changed = np.array([len(e) for e in edges])
        self.assertLess(np.median(changed), 6)

    def test_every_fifth_beam_keeps_its_direction(self):
        log = self.stressed("every5")
        for old, new in zip(self.before.scans(), log.scans()):
            np.testing.assert_array_equal(new.ranges_m, old.ranges_m[::5])
            np.testing.assert_allclose(new.angles_rad(), old.angles_rad()[::5], atol=1e-9)
            np.testing.assert_allclose(poses.between(new.odom_T_robot, new.odom_T_laser),
                                       [0.2, 0, 0], atol=1e-9)
        carmen.write(log, self.folder / "every5.clf")
        again = carmen.read(self.folder / "every5.clf").scans()
        np.testing.assert_allclose(again[3].angles_rad(),
                                   self.before.scans()[3].angles_rad()[::5], atol=1e-9)
        self.assertEqual(len(self.stressed("every10").scans()[0].ranges_m), 19)


if __name__ == "__main__":
    unittest.main()
