# SPDX-License-Identifier: BSD-3-Clause
"""The kinds of stress by name, and what they share."""
import dataclasses
from collections.abc import Callable

import numpy as np

import carmen
import poses

MOVING_M, MOVING_RAD = 0.01, 0.01  # a step of more than this is no noise of a standing robot


@dataclasses.dataclass(frozen=True)
class Stress:
    apply: Callable[[carmen.Log, np.random.Generator, float], None]
    meaning: str


STRESSES: dict[str, Stress] = {}


def stress(function):
    """Registers apply(log, rng, size), which changes the log, by its name. The docstring says what
    it does at size 1; size scales how bad it is."""
    STRESSES[function.__name__] = Stress(function, " ".join(function.__doc__.split()))
    return function


def odometry_of(scans: list[carmen.Scan]) -> np.ndarray:
    return np.array([scan.odom_T_robot for scan in scans])


def stamps_of(scans: list[carmen.Scan]) -> np.ndarray:
    return np.array([scan.stamp_s for scan in scans])


def set_odometry(log: carmen.Log, odom_T_robot: np.ndarray) -> None:
    """Gives the scans, in order of time, these poses. ODOM records keep their motion since the
    latest scan. Speeds, which would contradict, become zero."""
    scans = log.scans()
    new_T_old = poses.compose(odom_T_robot, poses.inverse(odometry_of(scans)))
    stamps_s = stamps_of(scans)
    for record in log.odometry():
        latest = max(np.searchsorted(stamps_s, record.stamp_s, side="right") - 1, 0)
        record.odom_T_robot = poses.compose(new_T_old[latest], record.odom_T_robot)
        record.speeds = ["0"] * len(record.speeds)
    for scan, pose in zip(scans, odom_T_robot):
        robot_T_laser = poses.between(scan.odom_T_robot, scan.odom_T_laser)
        scan.odom_T_robot = pose
        scan.odom_T_laser = poses.compose(pose, robot_T_laser)
        scan.speeds = ["0", "0", *scan.speeds[2:]] if scan.speeds else []


def moving_stretches(scans: list[carmen.Scan], rng: np.random.Generator, count: int,
                     seconds: float) -> list[tuple[int, int]]:
    """One to `count` stretches [first, last] of so many seconds that do not meet, at random among
    the half of them in which the robot moves most."""
    stamps_s, steps = stamps_of(scans), poses.steps_of(odometry_of(scans))
    motion = np.hypot(steps[:, 0], steps[:, 1]) + np.abs(steps[:, 2])
    travelled = np.concatenate([[0.0], np.cumsum(motion)])
    first = np.arange(1, len(scans) - 1)
    last = np.searchsorted(stamps_s, stamps_s[first] + seconds, side="right") - 1
    first, last = first[last < len(scans) - 1], last[last < len(scans) - 1]
    moved = travelled[last] - travelled[first - 1]
    return apart(first, last, moved, rng, count)


def apart(first: np.ndarray, last: np.ndarray, moved: np.ndarray, rng: np.random.Generator,
          count: int) -> list[tuple[int, int]]:
    """Stretches that do not touch, one or more, at random among the half with most motion."""
    if not first.size:
        raise carmen.LogError("the log is too short for this stress")
    candidates = np.flatnonzero(moved >= np.median(moved))
    chosen: list[tuple[int, int]] = []
    for i in rng.permutation(candidates):
        if len(chosen) == count:
            break
        if all(last[i] + 1 < f or l + 1 < first[i] for f, l in chosen):
            chosen.append((int(first[i]), int(last[i])))
    return sorted(chosen)
