# SPDX-License-Identifier: BSD-3-Clause
"""Logs are read and written without loss, and what is wrong is named with its line."""
import gzip
import unittest

import numpy as np
import stress_test_case

import carmen

ROBOTLASER1 = ("ROBOTLASER1 0 -1.0 2.0 0.5 20.0 0.01 0 5 1.0 2.0 20.0 3.5 0.25 2 7 8 "
               "1.200000 2.000000 0.000000 1.000000 2.000000 0.000000 0.1 0.2 0.3 0.4 0 "
               "{stamp} host 5.000000")


class CarmenTest(stress_test_case.StressTestCase):
    def read(self, text):
        self.file.write_text(text)
        return carmen.read(self.file)

    def test_what_is_read_is_written(self):
        carmen.write(self.before, self.folder / "again.clf.gz")
        again = gzip.decompress((self.folder / "again.clf.gz").read_bytes()).decode()
        for old, new in zip(stress_test_case.log_text().splitlines(), again.splitlines()):
            self.assertEqual(len(old.split()), len(new.split()))
            for a, b in zip(old.split(), new.split()):
                self.assertTrue(a == b or float(a) == float(b), (a, b))

    def test_robotlaser1_keeps_all_its_fields(self):
        lines = [ROBOTLASER1.format(stamp=f"{s}.000000") for s in (9, 10)]
        log = self.read("\n".join(lines))
        self.assertEqual([r.line() for r in log.records], lines)
        np.testing.assert_allclose(log.scans()[0].angles_rad(), [-1, -0.5, 0, 0.5, 1])

    def test_beams_without_angles_have_those_of_the_format(self):
        degrees = np.degrees(self.before.scans()[0].angles_rad())
        np.testing.assert_allclose(degrees[[0, 90, 180]], [-90, 0, 90])
        scan = self.before.scans()[0]
        scan.ranges_m = scan.ranges_m[:180]
        np.testing.assert_allclose(np.degrees(scan.angles_rad())[[0, 179]], [-90, 89])

    def test_scans_are_in_order_of_time(self):
        log = self.read("\n".join(ROBOTLASER1.format(stamp=f"{s}.000000") for s in (3, 1, 2)))
        self.assertEqual([s.stamp_s for s in log.scans()], [1, 2, 3])
        self.assertEqual([s.stamp_s for s in log.records], [3, 1, 2])

    def test_no_return_is_the_most_frequent_far_reading(self):
        self.assertEqual(self.before.no_return_m(), stress_test_case.NO_RETURN_M)
        scans = self.before.scans()
        scans[0].ranges_m[:5] = 60.0  # seldom
        self.assertEqual(self.before.no_return_m(), stress_test_case.NO_RETURN_M)
        for scan in scans:
            scan.ranges_m = np.minimum(scan.ranges_m, 12.0)
        self.assertEqual(self.before.no_return_m(), carmen.SICK_NO_RETURN_M)

    def test_the_mounting_is_what_param_says_else_what_scans_agree_on(self):
        np.testing.assert_allclose(self.before.robot_T_laser(), [0.2, 0, 0])
        self.before.records = [r for r in self.before.records if not isinstance(r, carmen.Other)]
        np.testing.assert_allclose(self.before.robot_T_laser(), [0.2, 0, 0], atol=2e-6)
        self.before.scans()[7].odom_T_laser[0] += 1.0  # as in a log that a map has corrected
        np.testing.assert_array_equal(self.before.robot_T_laser(), np.zeros(3))

    def test_bad_logs_are_named_with_line(self):
        for text, complaint in (("FLASER 3 1 2", r"log.clf:1: expected a FLASER"),
                                ("# x\nODOM 1 2 3", r"log.clf:2: expected a ODOM"),
                                ("RAWLASER1 0", r"log.clf:1: .*found RAWLASER1"),
                                ("# x", "expected two scans or more, found 0")):
            with self.assertRaisesRegex(carmen.LogError, complaint):
                self.read(text)
        self.file.write_bytes(gzip.compress(b"FLASER 1 2 0 0 0 0 0 0 1 host 1\n" * 9)[:-9])
        with self.assertRaisesRegex(carmen.LogError, "log.clf: "):
            carmen.read(self.file)


if __name__ == "__main__":
    unittest.main()
