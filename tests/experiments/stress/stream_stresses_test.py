# SPDX-License-Identifier: BSD-3-Clause
"""Scans that are missing, repeated or moved in time, and nothing else."""
import unittest

import numpy as np
import stress_test_case

import poses
import registry


class StreamStressesTest(stress_test_case.StressTestCase):
    def stamps(self, log):
        return [scan.stamp_s for scan in log.scans()]

    def test_frozen_scans_are_the_same_bit_for_bit_while_the_wheels_move(self):
        log = self.stressed("freeze", size=0.5)
        self.assert_odometry_untouched(log)
        self.assertEqual(self.stamps(log), self.stamps(self.before))
        same = [np.array_equal(a.ranges_m, b.ranges_m)
                for a, b in zip(log.scans(), log.scans()[1:])]
        self.assertIn(sum(same), range(40, 51))  # ten times five, or four where 0.5 s rounds down
        self.assertTrue(np.array_equal(log.scans()[0].ranges_m,
                                       self.before.scans()[0].ranges_m))

    def test_there_are_five_gaps_of_two_seconds(self):
        log = self.stressed("gaps")
        steps_s = np.diff(self.stamps(log))
        self.assertEqual((steps_s > 0.15).sum(), 5)
        np.testing.assert_allclose(steps_s[steps_s > 0.15], 2.1, atol=0.11)
        self.assertEqual(len(log.odometry()), len(self.before.odometry()))

    def test_thin_logs_have_a_scan_each_half_meter(self):
        for kind, distance_m in (("thin", 0.5), ("thin1m", 1.0)):
            log = self.stressed(kind)
            steps = poses.steps_of(registry.odometry_of(log.scans()))
            between_m = np.hypot(steps[:, 0], steps[:, 1])
            np.testing.assert_allclose(between_m, distance_m + 0.05, atol=0.06)
            self.assertEqual(len(log.odometry()), len(self.before.odometry()))

    def test_thin_logs_prefer_scans_that_relations_name(self):
        import stream_stresses
        for k, scan in enumerate(self.before.scans()):
            scan.is_in_relation = k % 6 == 0
        stream_stresses.thin(self.before, None, 1.0)
        scans = self.before.scans()
        self.assertGreater(len(scans), 40)
        self.assertTrue(all(scan.is_in_relation for scan in scans))

    def test_a_carried_robot_does_not_know(self):
        log = self.stressed("teleport")
        stamps_s = np.array(self.stamps(log))
        at = np.argmax(np.diff(stamps_s))
        self.assertAlmostEqual(np.diff(stamps_s)[at], 30.0 / 3, delta=0.21)
        odometry = registry.odometry_of(log.scans())
        np.testing.assert_allclose(odometry[at], odometry[at + 1], atol=1e-9)
        self.assertTrue(all(not 1010 <= r.stamp_s < 1019.9 for r in log.odometry()))

    def test_a_log_backwards_has_its_last_scan_first(self):
        log = self.stressed("reverse")
        lines = [r.line() for r in log.records]
        self.assertTrue(lines[0].startswith("#") and lines[1].startswith("PARAM"))
        stamps_s = [r.stamp_s for r in log.records[2:]]
        self.assertEqual(stamps_s, sorted(stamps_s))
        self.assertAlmostEqual(stamps_s[0], 999.95)
        self.assertAlmostEqual(stamps_s[-1], 1029.9)
        for old, new in zip(self.before.scans(), reversed(log.scans())):
            np.testing.assert_array_equal(old.ranges_m, new.ranges_m)
            np.testing.assert_array_equal(old.odom_T_robot, new.odom_T_robot)
            self.assertAlmostEqual(float(new.rest[1]), new.stamp_s - 990)

    def test_jitter_is_small_and_keeps_scans(self):
        moved = np.array([s.stamp_s - s.source_stamp_s for s in self.stressed("jitter").scans()])
        self.assertLess(np.abs(moved).max(), 0.0201)
        self.assertGreater(np.abs(moved).max(), 0.015)

    def test_a_clock_that_restarts_says_no_time_twice(self):
        log = self.stressed("clock_restart")
        in_file = [r.stamp_s for r in log.records if hasattr(r, "ranges_m")]
        self.assertEqual((np.diff(in_file) < 0).sum(), 1)
        self.assertEqual(min(in_file), 0.0)
        self.assertEqual(len(set(np.round(in_file, 6))), stress_test_case.SCANS)


if __name__ == "__main__":
    unittest.main()
