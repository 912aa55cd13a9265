# SPDX-License-Identifier: BSD-3-Clause
"""A made-up log whose every number is known, and what the tests of stresses ask of two logs."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
STRESS = ROOT / "experiments" / "stress"
sys.path.insert(0, str(STRESS))

import carmen
import registry

SCANS, BEAMS = 300, 181
NO_RETURN_M = 81.91


def pose_of(k):
    """0.1 m/scan on a circle of 5 m, from a place that is not the origin."""
    theta = 0.02 * k
    return 3 + 5 * np.sin(theta), 2 + 5 * (1 - np.cos(theta)), np.arctan2(np.sin(theta),
                                                                         np.cos(theta))


def log_text():
    """Ten FLASER a second from 1000 s on, an ODOM 0.05 s before each; the laser is 0.2 m ahead."""
    lines = ["# a comment", "PARAM robot_frontlaser_offset 0.2 host 0"]
    for k in range(SCANS):
        x, y, theta = pose_of(k)
        laser = f"{x + 0.2 * np.cos(theta):.6f} {y + 0.2 * np.sin(theta):.6f} {theta:.6f}"
        robot = f"{x:.6f} {y:.6f} {theta:.6f}"
        before = " ".join(f"{v:.6f}" for v in pose_of(k - 0.5))
        ranges = [f"{2 + 0.05 * i + 0.01 * k:.2f}" for i in range(BEAMS - 1)] + [f"{NO_RETURN_M}"]
        stamp = 1000 + 0.1 * k
        lines.append(f"ODOM {before} 1.0 0.2 0.0 {stamp - 0.05:.6f} host {stamp - 0.05 - 990:.6f}")
        lines.append(f"FLASER {BEAMS} {' '.join(ranges)} {laser} {robot} {stamp:.6f} host "
                     f"{stamp - 990:.6f}")
    return "\n".join(lines) + "\n"


class StressTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "log.clf"
        self.file.write_text(log_text())
        self.before = carmen.read(self.file)

    def stressed(self, kind, seed=1, size=1.0):
        import stresses
        log = carmen.read(self.file)
        stresses.apply(log, kind, seed, size)
        return log

    def assert_scans_untouched(self, log):
        self.assertEqual([s.stamp_s for s in log.scans()], [s.stamp_s for s in self.before.scans()])
        for old, new in zip(self.before.scans(), log.scans()):
            np.testing.assert_array_equal(old.ranges_m, new.ranges_m)

    def assert_odometry_untouched(self, log):
        self.assertEqual([r.line() for r in log.odometry()],
                         [r.line() for r in self.before.odometry()])
        np.testing.assert_array_equal(registry.odometry_of(log.scans()),
                                      registry.odometry_of(self.before.scans()))
