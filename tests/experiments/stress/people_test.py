# SPDX-License-Identifier: BSD-3-Clause
"""Walkers hide what is behind them, stay near the robot, and move at the speed of people."""
import unittest

import numpy as np
import stress_test_case

import people


class PeopleTest(stress_test_case.StressTestCase):
    def test_beams_end_at_a_disc_in_their_way(self):
        distance = people.distance_to_disc(np.radians([0, 4, 90, 180]), np.array([2.0, 0.0]), 0.25)
        self.assertAlmostEqual(distance[0], 1.75)
        self.assertTrue(1.75 < distance[1] < 2)
        np.testing.assert_array_equal(distance[2:], np.inf)

    def test_walkers_stay_near_and_go_smoothly(self):
        rng = np.random.default_rng(3)
        robot = np.zeros(2)
        walker = people.Walker(robot, rng)
        speeds = []
        for _ in range(2000):
            before = walker.xy
            robot = robot + [0.03, 0.0]
            walker.walk(robot, 0.1)
            speeds.append(np.hypot(*(walker.xy - before)) / 0.1)
            self.assertTrue(0.79 < np.hypot(*(walker.xy - robot)) < 4.01)
        self.assertAlmostEqual(np.median(speeds), 1.0, delta=0.01)
        self.assertLess(max(speeds), 2.0)

    def test_ranges_are_shortened_never_lengthened(self):
        log = self.stressed("people")
        self.assert_odometry_untouched(log)
        changed = 0
        for old, new in zip(self.before.scans(), log.scans()):
            self.assertTrue(np.all(new.ranges_m <= old.ranges_m))
            shorter = new.ranges_m < old.ranges_m
            changed += shorter.any()
            self.assertTrue(np.all(new.ranges_m[shorter] < 4.0))
        self.assertGreater(changed, 150)


if __name__ == "__main__":
    unittest.main()
