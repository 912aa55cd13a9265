# SPDX-License-Identifier: BSD-3-Clause
"""Random robots have flags that `simulate` has, and are of all sorts."""
import os
import pathlib
import sys
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "experiments" / "stress"), str(ROOT / "experiments" / "workflow")]

import flags
import random_robot

ROBOTS = [random_robot.draw_robot(np.random.default_rng(seed)) for seed in range(300)]


class RandomRobotTest(unittest.TestCase):
    def test_all_flags_are_those_of_simulate(self):
        known = flags.read_flags(pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"]) / "simulate")
        for robot in ROBOTS:
            self.assertLessEqual(robot.keys(), known.keys())

    def test_the_angle_between_beams_divides_the_field_of_view(self):
        numbers = set()
        for fov_deg, angle_deg in random_robot.LASERS:
            beams = fov_deg / angle_deg
            self.assertAlmostEqual(beams, round(beams))
            numbers.add(round(beams) + (fov_deg < 360))
        self.assertEqual((min(numbers), max(numbers)), (36, 1081))

    def test_there_are_robots_of_all_sorts(self):
        mounts = [robot["laser_mount"].split(",")[2] for robot in ROBOTS if "laser_mount" in robot]
        self.assertIn("180.0", mounts)
        self.assertIn("0.0", mounts)
        wheels = {robot.get("wheels") for robot in ROBOTS}
        self.assertEqual(wheels, {"exact", "silent", None})
        for flag in ("reverse", "motion_during_scan", "crowd", "wheel_ratio_bias", "slip_size"):
            self.assertTrue(10 < sum(flag in robot for robot in ROBOTS) < 200, flag)
        for flag, values in (("max_range", random_robot.RANGES_M),
                             ("scan_rate", random_robot.SCAN_RATES_HZ),
                             ("max_speed", random_robot.SPEEDS_M_S)):
            self.assertEqual({robot[flag] for robot in ROBOTS}, set(values))

    def test_slow_robots_with_fast_lasers_drive_shorter_tours(self):
        slow = {"scan_rate": 20, "max_speed": 0.3}
        rng = np.random.default_rng(1)
        self.assertEqual(random_robot.draw_length_m(slow, rng), 45)
        self.assertGreaterEqual(
            random_robot.draw_length_m({"scan_rate": 2, "max_speed": 1}, rng), 60)


if __name__ == "__main__":
    unittest.main()
