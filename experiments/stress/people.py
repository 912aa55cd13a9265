# SPDX-License-Identifier: BSD-3-Clause
"""Walkers about the robot that hide what is behind them."""
import numpy as np

import poses
from registry import stress

WALKERS = 3
NEAR_M, FAR_M = 0.8, 4.0  # from the robot
SPEED_M_S = 1.0
RADIUS_M = 0.25
TURN_RAD_S = 1.5


class Walker:
    """Goes smoothly from one place near the robot to another, in the frame of the odometry."""

    def __init__(self, robot_xy: np.ndarray, rng: np.random.Generator):
        self._rng = rng
        self._goal = self._place()  # relative to the robot, not turning with it
        self.xy = robot_xy + self._place()
        self._heading_rad = rng.uniform(-np.pi, np.pi)

    def walk(self, robot_xy: np.ndarray, seconds: float) -> None:
        to_goal = robot_xy + self._goal - self.xy
        if np.hypot(*to_goal) < 0.5:
            self._goal = self._place()
            to_goal = robot_xy + self._goal - self.xy
        turn = poses.wrap(np.arctan2(to_goal[1], to_goal[0]) - self._heading_rad)
        self._heading_rad += np.clip(turn, -TURN_RAD_S * seconds, TURN_RAD_S * seconds)
        direction = np.array([np.cos(self._heading_rad), np.sin(self._heading_rad)])
        self.xy = self.xy + SPEED_M_S * seconds * direction
        # Who falls behind hurries; who would walk into the robot steps aside.
        away = self.xy - robot_xy
        distance = max(np.hypot(*away), 1e-6)
        self.xy = robot_xy + away * np.clip(distance, NEAR_M, FAR_M) / distance

    def _place(self) -> np.ndarray:
        direction, distance = self._rng.uniform(-np.pi, np.pi), self._rng.uniform(NEAR_M, FAR_M)
        return distance * np.array([np.cos(direction), np.sin(direction)])


def distance_to_disc(angles_rad: np.ndarray, center: np.ndarray, radius_m: float) -> np.ndarray:
    """Along beams from the origin; infinite for those that pass it. The origin is outside."""
    along = np.cos(angles_rad) * center[0] + np.sin(angles_rad) * center[1]
    across_squared = center @ center - along**2
    hit = (along > 0) & (across_squared < radius_m**2)
    return np.where(hit, along - np.sqrt(np.maximum(radius_m**2 - across_squared, 0.0)), np.inf)


@stress
def people(log, rng, size):
    """three people of 0.5 m walk about the robot all the time, within 4 m, at 1 m/s"""
    scans = log.scans()
    walkers = [Walker(scans[0].odom_T_robot[:2], rng) for _ in range(WALKERS)]
    before_s = scans[0].stamp_s
    for scan in scans:
        seconds, before_s = min(scan.stamp_s - before_s, 1.0), scan.stamp_s
        angles = scan.angles_rad()
        for walker in walkers:
            walker.walk(scan.odom_T_robot[:2], seconds)
            laser = poses.between(scan.odom_T_laser, [*walker.xy, 0.0])[:2]
            hit_m = distance_to_disc(angles, laser, RADIUS_M * size)
            scan.ranges_m = np.where(hit_m < scan.ranges_m, np.round(hit_m, 3), scan.ranges_m)
