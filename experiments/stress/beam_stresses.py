# SPDX-License-Identifier: BSD-3-Clause
"""Beams that see less, or worse."""
import numpy as np

import poses
from carmen import NO_RETURN_FROM_M
from registry import stress


def _none(log):
    """By scan: the reading that says that nothing came back."""
    of_log = log.no_return_m()

    def of_scan(scan):
        return float(scan.beams[4]) if scan.beams and float(scan.beams[4]) > 0 else of_log
    return of_scan


@stress
def fov90(log, rng, size):
    """the middle 90 deg of the view; nothing comes back from the other beams"""
    none = _none(log)
    for scan in log.scans():
        scan.ranges_m[np.abs(scan.angles_rad()) > np.radians(45 * size) + 1e-9] = none(scan)


def _no_farther_than(log, limit_m):
    none = _none(log)
    for scan in log.scans():
        scan.ranges_m[scan.ranges_m > limit_m] = none(scan)


@stress
def range8(log, rng, size):
    """nothing comes back from farther than 8 m"""
    _no_farther_than(log, 8.0 * size)


@stress
def range5_6(log, rng, size):
    """nothing comes back from farther than 5.6 m"""
    _no_farther_than(log, 5.6 * size)


@stress
def unsaid_maximum(log, rng, size):
    """a laser of 8 m, whose readings are 8.00 where nothing comes back, and no record says so"""
    for scan in log.scans():
        scan.ranges_m[scan.ranges_m > 8.0 * size] = 8.0 * size
        if scan.beams:
            scan.beams[4] = "0"


@stress
def robot_parts(log, rng, size):
    """ten of each 45 beams end at 0.4 m, on parts of the robot, with noise of 0.01 m"""
    for scan in log.scans():
        on_robot = np.arange(len(scan.ranges_m)) % 45 < 10 * size
        part_m = 0.4 + 0.01 * rng.standard_normal(np.count_nonzero(on_robot))
        scan.ranges_m[on_robot] = np.round(part_m, 2)


@stress
def range_noise(log, rng, size):
    """ranges have noise of 0.05 m"""
    for scan in log.scans():
        noisy = scan.ranges_m + 0.05 * size * rng.standard_normal(len(scan.ranges_m))
        hit = (scan.ranges_m > 0) & (scan.ranges_m < NO_RETURN_FROM_M)
        scan.ranges_m = np.where(hit, np.round(np.maximum(noisy, 0.0), 3), scan.ranges_m)


@stress
def dropouts(log, rng, size):
    """nothing comes back from 10 % of the beams, and in a scan of ten from 20 deg on end"""
    none = _none(log)
    for scan in log.scans():
        lost = rng.random(len(scan.ranges_m)) < 0.1 * size
        if rng.random() < 0.1 * size:
            angles = scan.angles_rad()
            middle = rng.uniform(angles.min(), angles.max())
            lost |= np.abs(angles - middle) < np.radians(10)
        scan.ranges_m[lost] = none(scan)


@stress
def glass(log, rng, size):
    """at any time two or so sectors of 10 to 40 deg, which stay in their place for 2 to 6 s while
    the robot turns, give nothing back"""
    none, panes, before_s = _none(log), [], None
    for scan in log.scans():
        elapsed_s = min(scan.stamp_s - before_s, 1.0) if before_s is not None else 1.0
        before_s = scan.stamp_s
        for _ in range(rng.poisson(size * elapsed_s / 2)):  # a new one each 2 s; they last for 4
            heading = scan.odom_T_laser[2] + rng.uniform(-np.pi / 2, np.pi / 2)
            panes.append((scan.stamp_s + rng.uniform(2, 6), heading,
                          np.radians(rng.uniform(5, 20))))
        panes = [pane for pane in panes if pane[0] > scan.stamp_s]
        headings = scan.odom_T_laser[2] + scan.angles_rad()
        for _, heading, half_width in panes:
            scan.ranges_m[np.abs(poses.wrap(headings - heading)) < half_width] = none(scan)


def _every(log, stride):
    """FLASER becomes ROBOTLASER1, which can tell where its beams are."""
    robot_T_laser = log.robot_T_laser()
    for scan in log.scans():
        angles = scan.angles_rad()
        if scan.beams is None:
            scan.beams = ["0", "", "", "", "0", "0.01", "0"]
            scan.speeds = ["0", "0", "0", "0", "0"]
            scan.odom_T_laser = poses.compose(scan.odom_T_robot, robot_T_laser)
        kept = angles[::stride]
        scan.beams[1:4] = [repr(float(v)) for v in
                           (kept[0], kept[-1] - kept[0], (angles[1] - angles[0]) * stride)]
        scan.ranges_m = scan.ranges_m[::stride]
        scan.remissions = scan.remissions[::stride]


@stress
def every5(log, rng, size):
    """every 5th beam"""
    _every(log, max(1, round(5 * size)))


@stress
def every10(log, rng, size):
    """every 10th beam"""
    _every(log, max(1, round(10 * size)))
