#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""From scans to a map, from top to bottom like a notebook.

    PYTHONPATH=build/python experiments/python/example.py map.png                   # simulated
    PYTHONPATH=build/python experiments/python/example.py map.png robot.clf.gz      # your own log
"""

# %% What is needed
import sys

import matplotlib

matplotlib.use("Agg")  # a file, no window
import matplotlib.pyplot as plt
import numpy as np

import gmapping_spa as gs

if len(sys.argv) not in (2, 3):
    sys.exit("usage: example.py PICTURE [LOG]")
picture = sys.argv[1]

# %% A building of 20 m x 12 m, drawn into an array: a hall around a block, and some pillars
RESOLUTION_M = 0.025
cells = np.zeros((round(12 / RESOLUTION_M), round(20 / RESOLUTION_M)), np.int8)


def draw_box(x_min, y_min, x_max, y_max):
    columns = slice(round(x_min / RESOLUTION_M), round(x_max / RESOLUTION_M))
    rows = slice(round(y_min / RESOLUTION_M), round(y_max / RESOLUTION_M))
    cells[rows, columns] = 100


for wall in ((0, 0, 20, 0.2), (0, 11.8, 20, 12), (0, 0, 0.2, 12), (19.8, 0, 20, 12)):
    draw_box(*wall)
draw_box(5, 4, 15, 8)
for x, y in ((3, 6), (17, 6.5), (8, 1.2), (12, 10.6), (6.5, 10.8)):
    draw_box(x - 0.2, y - 0.2, x + 0.2, y + 0.2)
world = gs.OccupancyMap(cells, RESOLUTION_M)

# %% A robot with bad wheels drives around twice, or it is a log
truth = None
if len(sys.argv) == 3:
    scans = list(gs.CarmenLog(sys.argv[2]))
else:
    tour = [(2, 2), (10, 3), (18, 2), (18, 10), (10, 9), (2, 10), (2, 2), (10, 3), (18, 2), (18, 10)]
    run = gs.simulate(world, tour, beams=360, max_range_m=10, odometry_noise=3, seed=4)
    scans, truth = run.scans, run.truth
print(f"{len(scans)} scans")

# %% SLAM, scan by scan. From a driver's array it would be gs.LaserScan(stamp_s, ranges_m, ...)
slam = gs.Slam(gs.SlamOptions(particles=5, seed=1))
for scan in scans:
    result = slam.add_scan(scan)
    if result.closed_loop:
        print(f"loop closed at {scan.stamp_s:.1f} s")
slam.finish()
trajectory, graph = slam.trajectory, slam.graph
print(graph)

# %% How good is it? The estimate begins at the origin, the truth where the robot was put
if truth is not None:
    errors = gs.absolute_trajectory_error(truth, trajectory)
    print(f"absolute trajectory error: {errors.translation_m.rmse:.3f} m (RMSE)")


# %% The pose graph by itself, with a back end of one's own: here one that asks spa
class MyBackEnd:
    def optimize(self, nodes, edges):
        optimized, summary = gs.optimize(gs.PoseGraph(nodes, edges), loss="none")
        print(f"{len(nodes)} nodes, {len(edges)} edges: {summary}")
        return optimized.nodes["world_T_node"]


optimized, summary = gs.optimize(graph, MyBackEnd(), loss="none")
print(f"the cost went from {summary.initial_cost:.2f} to {summary.final_cost:.2f}")
sigmas_m = np.sqrt(gs.covariances(optimized)[:, [0, 1], [0, 1]].sum(axis=1))

# %% The map, the trajectory, and how well each node is known relative to the first one
figure, axes = plt.subplots(figsize=(10, 6), constrained_layout=True)
grid = slam.map
shade = np.choose(np.searchsorted([-1, 0, 100], grid.cells), [0.8, 1.0, 0.0])
axes.imshow(shade, cmap="gray", vmin=0, vmax=1, origin="lower", extent=grid.extent_m)
axes.plot(*trajectory["world_T_robot"][:, :2].T, color="tab:blue", linewidth=1, label="trajectory")
poses = optimized.nodes["world_T_node"]
dots = axes.scatter(*poses[:, :2].T, c=100 * sigmas_m, s=12, zorder=3, label="nodes of the graph")
for edge in graph.edges[graph.edges["kind"] == gs.EdgeKind.LOOP_CLOSURE]:
    ends = np.isin(graph.nodes["id"], [edge["i"], edge["j"]])
    axes.plot(*poses[ends, :2].T, color="tab:red", linewidth=0.5)
figure.colorbar(dots, label="standard deviation of the position, cm")
axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
axes.legend(loc="upper right")
figure.savefig(picture, dpi=120)
print(f"picture in {picture}")
