# SPDX-License-Identifier: BSD-3-Clause
"""A random robot: its laser, its wheels, how it drives and who walks about, as flags of `simulate`."""
from typing import Any

import numpy as np

RADIUS_M = 0.2
MOST_SCANS = 3000  # a slow robot with a fast laser drives a shorter tour

# Field of view and angle between two beams in degrees: 36 to 1081 beams.
LASERS = [(360, 10), (360, 5), (360, 2), (360, 1), (360, 0.5), (360, 0.36), (270, 0.5), (270, 0.25),
          (240, 1), (240, 0.3125), (180, 1), (180, 0.5), (120, 2), (120, 1)]
RANGES_M = [4, 5.6, 8, 10, 12, 16, 20, 30]
SCAN_RATES_HZ = [2, 4, 5, 8, 10, 15, 20]
SPEEDS_M_S = [0.3, 0.5, 0.7, 1, 1.5, 2]

Flags = dict[str, Any]


def draw_robot(rng: np.random.Generator) -> Flags:
    return {"robot_radius": RADIUS_M, **_draw_laser(rng), **_draw_wheels(rng), **_draw_drive(rng)}


def draw_length_m(flags: Flags, rng: np.random.Generator) -> float:
    """Of a tour for this robot."""
    return min(rng.uniform(60, 250), MOST_SCANS / flags["scan_rate"] * flags["max_speed"])


def _choice(rng: np.random.Generator, values: list):
    return values[rng.integers(len(values))]


def _draw_laser(rng: np.random.Generator) -> Flags:
    fov_deg, angle_deg = _choice(rng, LASERS)
    flags: Flags = {
        "fov_deg": fov_deg, "angular_resolution": angle_deg, "max_range": _choice(rng, RANGES_M),
        "scan_rate": _choice(rng, SCAN_RATES_HZ),
        "range_noise": _choice(rng, [0.005, 0.01, 0.02, 0.03])}
    if rng.random() < 0.3:
        flags["motion_during_scan"] = True
    if rng.random() < 0.5:
        heading_deg = _choice(rng, [0, 0, 180, rng.uniform(-60, 60)])
        flags["laser_mount"] = (f"{rng.uniform(-0.3, 0.3):.2f},{rng.uniform(-0.1, 0.1):.2f},"
                                f"{heading_deg:.1f}")
    return flags


def _draw_wheels(rng: np.random.Generator) -> Flags:
    """Exact, silent, good, noisy, biased or slipping."""
    return _choice(rng, [
        {"wheels": "exact"},
        {"wheels": "silent"},
        {"odometry_noise": _choice(rng, [0.3, 1]), "interference": _choice(rng, [0, 1])},
        {"odometry_noise": _choice(rng, [2, 5]), "interference": _choice(rng, [1, 2])},
        {"wheel_ratio_bias": 0.02, "wheel_scale_bias": 0.03,
         "wheel_base_factor": round(rng.uniform(0.9, 1.1), 3)},
        {"slip_probability": 0.1, "slip_size": 0.8, "slip_duration_s": 1,
         "bump_probability": 0.05}])


def _draw_drive(rng: np.random.Generator) -> Flags:
    flags: Flags = {"max_speed": _choice(rng, SPEEDS_M_S), "max_turn_rate": _choice(rng, [0.5, 1, 2])}
    if rng.random() < 0.15:
        flags["reverse"] = True
    people = _choice(rng, [0, 0, 0, 3, 8])
    return flags | ({"crowd": people} if people else {})
