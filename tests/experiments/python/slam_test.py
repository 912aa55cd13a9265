# SPDX-License-Identifier: BSD-3-Clause
"""SLAM from Python is that of the executable, with any back end."""

import logging
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np
import room
from executable import BINARIES, expect_the_same_bytes, slam_of

import gmapping_spa as gs


def arrays_again(scan):
    """The scan once more, as a driver would give it."""
    beams = scan.beams
    ranges = np.where(beams["status"] == gs.BeamStatus.INVALID, np.nan, beams["range_m"])
    angles = beams["angle_rad"]
    return gs.LaserScan(
        scan.stamp_s, ranges, angle_min_rad=angles[0], angle_step_rad=angles[1] - angles[0],
        odom_T_robot=scan.odom_T_robot, robot_T_laser=scan.robot_T_laser, usable_range_m=12)


class ExecutableTest(unittest.TestCase):
    def test_the_same_bytes_on_a_simulated_log(self):
        worlds = pathlib.Path(__file__).resolve().parents[3] / "experiments/simulation/worlds"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([BINARIES / "simulate", f"--world={worlds}/paper_building.yaml",
                            f"--path={worlds}/paper_building.short.path.yaml", "--scan_rate=2",
                            "--angular_resolution=2", f"--output_dir={folder}"],
                           check=True, capture_output=True)
            expect_the_same_bytes(self, f"{folder}/log.clf", ["--particles=3", "--seed=7"],
                                  gs.SlamOptions(particles=3, seed=7))

    def test_a_log_that_is_none_is_an_error(self):
        with tempfile.NamedTemporaryFile("w", suffix=".clf") as log:
            log.write("FLASER 3 1.0 x 2.0 0 0 0 0 0 0 1.0 host 1.0\n")
            log.flush()
            with self.assertRaisesRegex(RuntimeError, r"clf"):
                list(gs.CarmenLog(log.name))
        with self.assertRaisesRegex(RuntimeError, "No such file"):
            gs.CarmenLog("/none/robot.clf")


class SlamTest(unittest.TestCase):
    def test_finds_the_truth_and_tells_all(self):
        run = room.run()
        slam = gs.Slam(gs.SlamOptions(particles=3))
        results = [slam.add_scan(scan) for scan in run.scans]
        self.assertTrue(any(result.updated for result in results))
        self.assertFalse(any(result.lost for result in results))
        np.testing.assert_array_equal(results[0].world_T_robot, [0, 0, 0])
        slam.finish()
        slam.finish()
        errors = gs.absolute_trajectory_error(run.truth, slam.trajectory)
        self.assertLess(errors.translation_m.rmse, 0.05)
        np.testing.assert_array_equal(slam.pose, slam.trajectory["world_T_robot"][-1])
        grid = slam.map
        self.assertEqual(grid.resolution_m, 0.05)
        self.assertEqual(set(np.unique(grid.cells)), {-1, 0, 100})
        self.assertGreater(len(slam.graph.nodes), 10)
        with self.assertRaises(RuntimeError):
            slam.add_scan(run.scans[-1])

    def test_arrays_of_a_driver_do_as_well(self):
        scans = room.run().scans[:60]
        expected = slam_of(scans).trajectory
        again = slam_of(map(arrays_again, scans)).trajectory
        np.testing.assert_allclose(again["world_T_robot"], expected["world_T_robot"], atol=1e-6)

    def test_options_are_those_of_the_executable(self):
        options = gs.SlamOptions(particles=7, odometry="lidar_only", loss="huber", init="chordal")
        self.assertEqual((options.particles, options.odometry), (7, "lidar_only"))
        self.assertEqual((options.loss, options.init), ("huber", "chordal"))
        self.assertEqual(options, options.copy())
        self.assertNotEqual(options, gs.SlamOptions())
        self.assertEqual(gs.SlamOptions.plain_gmapping().backend, "none")
        names = [name for name in dir(options) if not name.startswith("_")]
        flags = subprocess.run([BINARIES / "gmapping_spa", "--help"], capture_output=True,
                               text=True).stdout
        for name in set(names) - {"copy", "improved", "paper", "plain_gmapping", "settings"}:
            self.assertIn(f"    -{name} (", flags)


class PythonBackEndTest(unittest.TestCase):
    def test_slam_uses_it(self):
        class Counting:
            calls = 0

            def optimize(self, nodes, edges):
                self.calls += 1
                return gs.optimize(gs.PoseGraph(nodes, edges), loss="none")[0].nodes["world_T_node"]

        counting = Counting()
        options = gs.SlamOptions(loss="none")
        own = slam_of(room.run().scans, options, counting)
        self.assertGreater(counting.calls, 1)
        spa = slam_of(room.run().scans, options)
        np.testing.assert_allclose(own.trajectory["world_T_robot"],
                                   spa.trajectory["world_T_robot"], atol=1e-3)

    def test_one_that_fails_costs_its_results_and_says_so(self):
        for broken in (
            lambda self, n, e: 1 / 0,
            lambda self, n, e: "garbage",
            lambda self, n, e: n["world_T_node"] * np.nan,
            lambda self, n, e: n["world_T_node"][:-1],
        ):
            back_end = type("Broken", (), {"optimize": broken})()
            with self.assertLogs("gmapping_spa", logging.WARNING):
                slam = slam_of(room.run().scans[:100], gs.SlamOptions(loss="none"), back_end)
            self.assertEqual(len(slam.trajectory), 100)


if __name__ == "__main__":
    unittest.main()
