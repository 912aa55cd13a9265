# SPDX-License-Identifier: BSD-3-Clause
"""Pose graphs of any size: a random walk on the streets of a square city, with its true poses."""
import math
import random

SIGMA_M, SIGMA_RAD = 0.05, 0.02


def walk(poses, half_side, closure_part, seed=1, turn_part=0.25):
    """True poses (x, y, quarter turns), steps of 1 m, and the pairs of loop closures.

    A robot that is where it was before closes a loop with one of those poses in this part of all
    cases.
    """
    draw = random.Random(seed)
    steps = ((1, 0), (0, 1), (-1, 0), (0, -1))
    x = y = heading = 0
    truth, closures, visits = [], [], {}
    for k in range(poses):
        truth.append((x, y, heading))
        here = visits.setdefault((x, y), [])
        if here and k - here[-1] > 10 and draw.random() < closure_part:
            closures.append((draw.choice(here), k))
        here.append(k)
        if draw.random() < turn_part:
            heading = (heading + draw.choice((1, 3))) % 4
        if max(abs(x + steps[heading][0]), abs(y + steps[heading][1])) > half_side:
            heading = (heading + 2) % 4
        x, y = x + steps[heading][0], y + steps[heading][1]
    return truth, closures


def measure(truth, i, j, draw):
    """The noisy pose of j in the frame of i."""
    (x_i, y_i, h_i), (x_j, y_j, h_j) = truth[i], truth[j]
    cos, sin = ((1, 0), (0, 1), (-1, 0), (0, -1))[h_i]
    dx, dy = x_j - x_i, y_j - y_i
    turn = ((h_j - h_i + 2) % 4 - 2) * math.pi / 2
    return (cos * dx + sin * dy + draw.gauss(0, SIGMA_M), -sin * dx + cos * dy + draw.gauss(0, SIGMA_M),
            turn + draw.gauss(0, SIGMA_RAD))


def write_graph(path, truth, closures, seed=1):
    """Writes a .g2o file whose poses are those of the odometry."""
    draw = random.Random(seed + 1)
    information = f"{SIGMA_M ** -2:.6g} 0 0 {SIGMA_M ** -2:.6g} 0 {SIGMA_RAD ** -2:.6g}"
    pairs = [(k, k + 1) for k in range(len(truth) - 1)] + closures
    x = y = theta = 0.0
    edges = []
    with open(path, "w", encoding="ascii") as file:
        file.write("VERTEX_SE2 0 0 0 0\n")
        for i, j in pairs:
            dx, dy, turn = measure(truth, i, j, draw)
            edges.append(f"EDGE_SE2 {i} {j} {dx:.6f} {dy:.6f} {turn:.6f} {information}\n")
            if j == i + 1:
                x += math.cos(theta) * dx - math.sin(theta) * dy
                y += math.sin(theta) * dx + math.cos(theta) * dy
                theta = math.remainder(theta + turn, 2 * math.pi)
                file.write(f"VERTEX_SE2 {j} {x:.6f} {y:.6f} {theta:.6f}\n")
        file.writelines(edges)
