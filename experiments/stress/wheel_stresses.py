# SPDX-License-Identifier: BSD-3-Clause
"""Wheels that are wrong: the scans stay as they are."""
import numpy as np

import poses
from registry import (MOVING_M, MOVING_RAD, apart, odometry_of, set_odometry, stamps_of, stress)

TRACK_M = 0.4  # distance of the wheels of a robot of these logs, about


def _with_wrong_steps(log, at, errors):
    """`errors` are motions added to the steps that lead to the scans `at`."""
    odometry = odometry_of(log.scans())
    steps = poses.steps_of(odometry)
    steps[at - 1] = poses.compose(steps[at - 1], errors)
    set_odometry(log, poses.chain(odometry[0], steps))


def _some_scans(log, rng, count):
    """Scans but the first, at random."""
    n = len(log.scans())
    return np.sort(rng.choice(np.arange(1, n), size=min(count, n - 1), replace=False))


@stress
def yawjump(log, rng, size):
    """20 single steps of the wheels turn too far or too little by 15 to 60 deg"""
    at = _some_scans(log, rng, 20)
    errors = np.zeros((len(at), 3))
    errors[:, 2] = size * np.radians(rng.uniform(15, 60, len(at))) * rng.choice([-1, 1], len(at))
    _with_wrong_steps(log, at, errors)


@stress
def jump(log, rng, size):
    """10 single steps of the wheels are wrong by 0.5 m in any direction and 30 deg"""
    at = _some_scans(log, rng, 10)
    direction = rng.uniform(-np.pi, np.pi, len(at))
    turn = np.radians(30) * rng.choice([-1, 1], len(at))
    _with_wrong_steps(log, at, size * np.stack(
        [0.5 * np.cos(direction), 0.5 * np.sin(direction), turn], axis=-1))


@stress
def silent(log, rng, size):
    """the wheels always say 0 0 0"""
    set_odometry(log, np.zeros((len(log.scans()), 3)))
    for record in log.odometry():
        record.odom_T_robot = np.zeros(3)


@stress
def late(log, rng, size):
    """odometry is 0.15 s late"""
    scans = log.scans()
    stamps_s, odometry = stamps_of(scans), odometry_of(scans)
    theta = np.unwrap(odometry[:, 2])
    then_s = stamps_s - 0.15 * size
    set_odometry(log, np.stack([
        np.interp(then_s, stamps_s, odometry[:, 0]), np.interp(then_s, stamps_s, odometry[:, 1]),
        poses.wrap(np.interp(then_s, stamps_s, theta))], axis=-1))


@stress
def reset(log, rng, size):
    """the encoders restart at zero once, in the middle third"""
    odometry = odometry_of(log.scans())
    at = rng.integers(len(odometry) // 3, 2 * len(odometry) // 3 + 1)
    odometry[at:] = poses.between(odometry[at], odometry[at:])
    set_odometry(log, odometry)


@stress
def encoder_wrap(log, rng, size):
    """x jumps by 65.536 m once, in the middle third, as a 16 bit counter of millimeters does"""
    odometry = odometry_of(log.scans())
    odometry[rng.integers(len(odometry) // 3, 2 * len(odometry) // 3 + 1):, 0] -= 65.536 * size
    set_odometry(log, odometry)


@stress
def first_garbage(log, rng, size):
    """the first 3 odometry readings are nonsense, up to 1e6 m"""
    odometry = odometry_of(log.scans())
    garbage = odometry[:3]
    garbage[:, :2] = size * 10 ** rng.uniform(3, 6, (len(garbage), 2)) * rng.choice(
        [-1, 1], (len(garbage), 2))
    garbage[:, 2] = rng.uniform(-np.pi, np.pi, len(garbage))
    set_odometry(log, odometry)


@stress
def drop(log, rng, size):
    """5 times the odometry stands still for 4 scans, then catches up at once"""
    odometry, count = odometry_of(log.scans()), max(1, round(4 * size))
    steps = poses.steps_of(odometry)
    motion = np.hypot(steps[:, 0], steps[:, 1]) + np.abs(steps[:, 2])
    travelled = np.concatenate([[0.0], np.cumsum(motion)])
    first = np.arange(1, len(odometry) - count)
    moved = travelled[first + count] - travelled[first - 1]
    for begin, end in apart(first, first + count - 1, moved, rng, 5):
        odometry[begin:end + 1] = odometry[begin - 1]
    set_odometry(log, odometry)


def _with_steps(log, change):
    """Every step of the wheels changed by a function of the steps."""
    odometry = odometry_of(log.scans())
    set_odometry(log, poses.chain(odometry[0], change(poses.steps_of(odometry))))


@stress
def scale(log, rng, size):
    """distances and turns are 5 % too long"""
    _with_steps(log, lambda steps: steps * (1 + 0.05 * size))


@stress
def feet(log, rng, size):
    """distances are in feet instead of meters (of size 304.8: in millimeters)"""
    _with_steps(log, lambda steps: steps * [size / 0.3048, size / 0.3048, 1.0])


@stress
def noisy(log, rng, size):
    """each step of the wheels has noise of 20 % of its length, and of its turn"""
    def change(steps):
        distance = np.hypot(steps[:, 0], steps[:, 1])
        sigma = 0.2 * size * np.stack([distance, distance, np.abs(steps[:, 2])], axis=-1)
        return steps + sigma * rng.standard_normal(steps.shape)
    _with_steps(log, change)


@stress
def wheel_bias(log, rng, size):
    """the right wheel, 0.4 m from the left one, is 2 % larger than the odometry assumes"""
    def change(steps):
        too_far = 0.02 * size * (steps[:, 0] + steps[:, 2] * TRACK_M / 2)
        return steps + np.stack([too_far / 2, np.zeros(len(steps)), too_far / TRACK_M], axis=-1)
    _with_steps(log, change)


@stress
def yaw_drift(log, rng, size):
    """the heading drifts by 0.5 deg/s while the robot moves"""
    seconds = np.minimum(np.diff(stamps_of(log.scans())), 1.0)

    def change(steps):
        moving = (np.hypot(steps[:, 0], steps[:, 1]) > MOVING_M) | (abs(steps[:, 2]) > MOVING_RAD)
        turn = np.where(moving, np.radians(0.5 * size) * seconds, 0.0)
        return steps + turn[:, None] * [0.0, 0.0, 1.0]
    _with_steps(log, change)
