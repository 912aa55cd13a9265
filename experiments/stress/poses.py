# SPDX-License-Identifier: BSD-3-Clause
"""Poses in the plane as arrays (..., 3) of x, y (m) and theta (rad)."""
import numpy as np


def wrap(angle_rad):
    """The same angle in [-pi, pi)."""
    return (angle_rad + np.pi) % (2 * np.pi) - np.pi


def cos_sin(angle_rad):
    """Of an angle or an array. NumPy has several implementations of each; which of them a view
    with gaps gets depends on addresses in memory, and so would the last digit."""
    angle_rad = np.array(angle_rad, order="C")
    return np.cos(angle_rad), np.sin(angle_rad)


def compose(a_T_b, b_T_c):
    """a_T_c"""
    a_T_b, b_T_c = np.asarray(a_T_b, float), np.asarray(b_T_c, float)
    cos, sin = cos_sin(a_T_b[..., 2])
    x, y = b_T_c[..., 0], b_T_c[..., 1]
    return np.stack([a_T_b[..., 0] + cos * x - sin * y, a_T_b[..., 1] + sin * x + cos * y,
                     wrap(a_T_b[..., 2] + b_T_c[..., 2])], axis=-1)


def inverse(a_T_b):
    """b_T_a"""
    a_T_b = np.asarray(a_T_b, float)
    cos, sin = cos_sin(a_T_b[..., 2])
    x, y = a_T_b[..., 0], a_T_b[..., 1]
    return np.stack([-cos * x - sin * y, sin * x - cos * y, wrap(-a_T_b[..., 2])], axis=-1)


def between(w_T_a, w_T_b):
    """a_T_b"""
    return compose(inverse(w_T_a), w_T_b)


def steps_of(odom_T_robot):
    """The motion from each pose to the next: one fewer than there are poses."""
    return between(odom_T_robot[:-1], odom_T_robot[1:])


def chain(first, steps):
    """The poses that these steps lead to, `first` included."""
    theta = first[2] + np.concatenate([[0.0], np.cumsum(steps[:, 2])])
    cos, sin = cos_sin(theta[:-1])
    x = first[0] + np.concatenate([[0.0], np.cumsum(cos * steps[:, 0] - sin * steps[:, 1])])
    y = first[1] + np.concatenate([[0.0], np.cumsum(sin * steps[:, 0] + cos * steps[:, 1])])
    return np.stack([x, y, wrap(theta)], axis=-1)
