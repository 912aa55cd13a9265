# SPDX-License-Identifier: BSD-3-Clause
"""A small world, for tests of the Python module."""

import functools

import numpy as np

import gmapping_spa as gs

TOUR = [(2, 2), (8, 2), (8, 6), (2, 6), (2, 2), (8, 2)]


def world():
    """A room of 10 m x 8 m with a block in the middle and a pillar."""
    cells = np.zeros((160, 200), np.int8)
    cells[:4], cells[-4:], cells[:, :4], cells[:, -4:] = 100, 100, 100, 100
    cells[70:90, 80:120] = 100
    cells[140:146, 60:66] = 100
    return gs.OccupancyMap(cells, 0.05)


@functools.cache
def run():
    """About 200 scans, twice through the same places."""
    return gs.simulate(world(), TOUR, beams=180, max_range_m=12, scan_rate_hz=5, seed=3)


def square_graph():
    """A square that was driven, each side measured 10.2 m long, and the way back to the start."""
    nodes = np.zeros(4, gs.NODE_DTYPE)
    nodes["id"] = [10, 20, 30, 40]
    nodes["world_T_node"] = [
        (0, 0, 0), (10.2, 0, np.pi / 2), (10.2, 10.2, np.pi), (0, 10.2, -np.pi / 2)
    ]
    edges = np.zeros(4, gs.EDGE_DTYPE)
    edges["i"], edges["j"] = [10, 20, 30, 40], [20, 30, 40, 10]
    edges["i_T_j"] = (10.2, 0, np.pi / 2)
    edges["i_T_j"][3] = (10.0, 0, np.pi / 2)
    edges["information"] = np.eye(3)
    edges["kind"][3] = gs.EdgeKind.LOOP_CLOSURE
    return gs.PoseGraph(nodes, edges)
