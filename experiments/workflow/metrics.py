# SPDX-License-Identifier: BSD-3-Clause
"""The metrics that a study can show: key, label, unit, and which direction is better."""
import dataclasses
import math
from typing import Literal

Direction = Literal["lower", "higher", "none"]


@dataclasses.dataclass(frozen=True)
class Metric:
    key: str
    label: str
    unit: str
    better: Direction


_TABLE = [
    # Hand-checked relations of the Freiburg benchmark.
    ("relation_error_m", "mean relation error", "m", "lower"),
    ("relation_std_m", "standard deviation of the relation error", "m", "lower"),
    ("relation_median_m", "median relation error", "m", "lower"),
    ("relation_rotation_deg", "mean rotation error of relations", "deg", "lower"),
    ("relations_used", "relations used", "", "none"),
    # Trajectory against truth.
    ("ate_rmse_m", "RMSE of the position (ATE)", "m", "lower"),
    ("ate_max_m", "largest position error", "m", "lower"),
    ("heading_rmse_deg", "RMSE of the heading", "deg", "lower"),
    ("rpe_m_per_m", "relative error (RPE) over 1 m", "m/m", "lower"),
    # Map against truth, where the robot could see.
    ("map_blur_m", "boundary blur", "m", "lower"),
    ("map_missing", "missing boundary", "", "lower"),
    ("map_shift_m", "boundary shift", "m", "lower"),
    ("map_shift_p95_m", "boundary shift, 95th percentile", "m", "lower"),
    ("map_extra", "occupied where truth is free", "", "lower"),
    ("map_precision", "precision of occupied cells", "", "higher"),
    ("map_recall", "recall of occupied cells", "", "higher"),
    ("map_iou", "overlap (IoU) of occupied cells", "", "higher"),
    ("map_to_truth_m", "distance from map to truth", "m", "lower"),
    ("map_to_truth_p95_m", "distance from map to truth, 95th percentile", "m", "lower"),
    ("truth_to_map_m", "distance from truth to map", "m", "lower"),
    ("truth_to_map_p95_m", "distance from truth to map, 95th percentile", "m", "lower"),
    ("map_known", "known part", "", "higher"),
    ("map_broken", "share of broken runs (IoU below 0.5)", "", "lower"),
    ("map_ghost_walls", "ghost walls", "", "lower"),
    ("map_ghost_walls_m", "length of ghost walls", "m", "lower"),
    ("map_doubled_walls_m", "length of walls drawn twice", "m", "lower"),
    ("map_missing_walls", "share of walls that are missing", "", "lower"),
    ("map_broken_walls", "share of walls drawn with gaps", "", "lower"),
    ("map_wall_gaps", "gaps in walls", "", "lower"),
    ("map_corners_found", "share of corners found", "", "higher"),
    ("map_corners_false", "false corners", "", "lower"),
    # The obstacles of an experiment by themselves.
    ("obstacles_there", "share of obstacles that are there", "", "higher"),
    ("obstacles_complete", "part of the obstacles' boundary that is drawn", "", "higher"),
    ("obstacles_blur_m", "blur of the obstacles' boundary", "m", "lower"),
    # Map alone.
    ("map_occupied_cells", "occupied cells", "", "none"),
    ("map_enclosed_areas", "enclosed areas", "", "none"),
    ("map_corners", "corners", "", "none"),
    # Cost and counts.
    ("cpu_s", "CPU time", "s", "lower"),
    ("wall_s", "wall time", "s", "lower"),
    ("peak_memory_mb", "peak memory", "MB", "lower"),
    ("updates", "updates of the filter", "", "none"),
    ("closures_accepted", "accepted loop closures", "", "none"),
    ("closures_rejected", "rejected loop closures", "", "none"),
    ("scans", "scans", "", "none"),
]

METRICS = {row[0]: Metric(*row) for row in _TABLE}

# From 0 to 1; all other metrics are 0 or more.
SHARES = {"map_missing", "map_extra", "map_precision", "map_recall", "map_iou", "map_known", "map_broken",
          "map_missing_walls", "map_broken_walls", "map_corners_found", "obstacles_there",
          "obstacles_complete"}


def highest(key: str) -> float:
    """The largest value that the metric can have."""
    return 1.0 if key in SHARES else math.inf


# Differ from one execution of the same run to the next.
TIMES = {"cpu_s", "wall_s", "peak_memory_mb"}
# Says how busy the machine was; stands in the table of single runs only.
WALL_TIME = "wall_s"
