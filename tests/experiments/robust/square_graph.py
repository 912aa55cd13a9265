# SPDX-License-Identifier: BSD-3-Clause
"""A small graph with its truth: three rounds of a square, right loop closures, exact measurements."""
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "experiments" / "robust"))

SIDE, ROUNDS = 10, 3
INFORMATION = "100 0 0 100 0 1000"


def lines_and_truth():
    """Lines of a .g2o file without vertices, and (x, y, theta) of each node."""
    truth, pose = [], (0.0, 0.0, 0.0)
    for k in range(4 * SIDE * ROUNDS):
        truth.append(pose)
        x, y, theta = pose
        turn = math.pi / 2 if k % SIDE == SIDE - 1 else 0.0
        pose = (x + math.cos(theta), y + math.sin(theta), theta + turn)
    lines = []
    for k in range(1, len(truth)):
        turn = math.pi / 2 if k % SIDE == 0 else 0.0
        lines.append(f"EDGE_SE2 {k - 1} {k} 1 0 {turn} {INFORMATION}")
    loop = 4 * SIDE
    for k in range(0, len(truth) - loop, 3):
        lines.append(f"EDGE_SE2 {k} {k + loop} 0 0 0 {INFORMATION}")
    return lines, truth
