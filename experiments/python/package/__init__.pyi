# SPDX-License-Identifier: BSD-3-Clause
# Types of the package; what they mean is said by help() of each.
import enum
import os
from typing import Any, Iterator, Literal, Protocol, Sequence

import numpy as np
import numpy.typing as npt

from gmapping_spa._slam_options import Initialization, Loss
from gmapping_spa._slam_options import SlamOptions as SlamOptions

__version__: str

Path = str | os.PathLike[str]
Array = npt.NDArray[np.float64]
# Structured arrays of the types below.
Trajectory = npt.NDArray[np.void]
Nodes = npt.NDArray[np.void]
Edges = npt.NDArray[np.void]

TRAJECTORY_DTYPE: np.dtype[np.void]
BEAM_DTYPE: np.dtype[np.void]
NODE_DTYPE: np.dtype[np.void]
EDGE_DTYPE: np.dtype[np.void]

class EdgeKind(enum.IntEnum):
    ODOMETRY = 0
    SCAN_MATCH = 1
    LOOP_CLOSURE = 2

class BeamStatus(enum.IntEnum):
    HIT = 0
    NO_RETURN = 1
    INVALID = 2

class BackEnd(Protocol):
    """What a back end in Python is: poses (N, 3), or None when it changed the nodes."""

    def optimize(self, nodes: Nodes, edges: Edges) -> npt.ArrayLike | None: ...

class LaserScan:
    def __init__(
        self,
        stamp_s: float,
        ranges_m: npt.ArrayLike,
        *,
        angle_min_rad: float | None = None,
        angle_step_rad: float | None = None,
        odom_T_robot: npt.ArrayLike | None = None,
        robot_T_laser: npt.ArrayLike = (0.0, 0.0, 0.0),
        range_min_m: float = 0.05,
        usable_range_m: float = 40.0,
    ) -> None: ...
    def __len__(self) -> int: ...
    @property
    def index(self) -> int: ...
    @property
    def stamp_s(self) -> float: ...
    @property
    def odom_T_robot(self) -> Array | None: ...
    @property
    def robot_T_laser(self) -> Array: ...
    @property
    def beams(self) -> npt.NDArray[np.void]: ...

class CarmenLog:
    def __init__(
        self,
        path: Path,
        *,
        usable_range_m: float = 40.0,
        range_min_m: float = 0.05,
        fov_rad: float | None = None,
        angle_min_rad: float | None = None,
        robot_T_laser: npt.ArrayLike | None = None,
        flipped: bool = False,
        strict: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[LaserScan]: ...
    def __next__(self) -> LaserScan: ...
    @property
    def counts(self) -> dict[str, int]: ...

class OccupancyMap:
    def __init__(
        self,
        cells: npt.ArrayLike,
        resolution_m: float,
        origin_x_m: float = 0.0,
        origin_y_m: float = 0.0,
    ) -> None: ...
    @property
    def cells(self) -> npt.NDArray[np.int8]: ...
    @property
    def resolution_m(self) -> float: ...
    @property
    def origin_x_m(self) -> float: ...
    @property
    def origin_y_m(self) -> float: ...
    @property
    def extent_m(self) -> tuple[float, float, float, float]: ...
    def write(self, yaml_path: Path) -> None: ...

class PoseGraph:
    def __init__(self, nodes: Nodes, edges: Edges) -> None: ...
    @property
    def nodes(self) -> Nodes: ...
    @property
    def edges(self) -> Edges: ...
    def copy(self) -> PoseGraph: ...

class Summary:
    @property
    def converged(self) -> bool: ...
    @property
    def message(self) -> str: ...
    @property
    def initial_cost(self) -> float: ...
    @property
    def final_cost(self) -> float: ...
    @property
    def iterations(self) -> int: ...
    @property
    def edge_weights(self) -> Array: ...

class Certificate:
    @property
    def optimal(self) -> bool: ...
    @property
    def cost(self) -> float: ...
    @property
    def lower_bound(self) -> float: ...
    @property
    def relative_gap(self) -> float: ...

class ScanResult:
    @property
    def world_T_robot(self) -> Array: ...
    @property
    def updated(self) -> bool: ...
    @property
    def closed_loop(self) -> bool: ...
    @property
    def corrected(self) -> bool: ...
    @property
    def ambiguous(self) -> bool: ...
    @property
    def lost(self) -> bool: ...

class Slam:
    def __init__(
        self, options: SlamOptions = ..., backend: str | BackEnd | None = None
    ) -> None: ...
    def add_scan(self, scan: LaserScan) -> ScanResult: ...
    def finish(self) -> None: ...
    @property
    def pose(self) -> Array: ...
    @property
    def map(self) -> OccupancyMap: ...
    @property
    def graph(self) -> PoseGraph: ...
    @property
    def trajectory(self) -> Trajectory: ...

class Statistics:
    @property
    def rmse(self) -> float: ...
    @property
    def mean(self) -> float: ...
    @property
    def median(self) -> float: ...
    @property
    def std(self) -> float: ...
    @property
    def min(self) -> float: ...
    @property
    def max(self) -> float: ...

class Relation:
    def __init__(self, stamp_i_s: float, stamp_j_s: float, i_T_j: npt.ArrayLike) -> None: ...
    @property
    def stamp_i_s(self) -> float: ...
    @property
    def stamp_j_s(self) -> float: ...
    @property
    def i_T_j(self) -> Array: ...

class RelationErrors:
    @property
    def used(self) -> int: ...
    @property
    def not_associated(self) -> int: ...
    @property
    def translation_m(self) -> Statistics: ...
    @property
    def rotation_deg(self) -> Statistics: ...

class PoseErrors:
    @property
    def pairs(self) -> int: ...
    @property
    def translation_m(self) -> Statistics: ...
    @property
    def rotation_deg(self) -> Statistics: ...

class SimulatedRun:
    @property
    def scans(self) -> list[LaserScan]: ...
    @property
    def truth(self) -> Trajectory: ...
    @property
    def truth_map(self) -> OccupancyMap: ...
    @property
    def path_length_m(self) -> float: ...

def read_tum(path: Path) -> Trajectory: ...
def write_tum(path: Path, trajectory: Trajectory) -> None: ...
def read_map(yaml_path: Path) -> OccupancyMap: ...
def read_g2o(path: Path, *, strict: bool = False) -> PoseGraph: ...
def write_g2o(path: Path, graph: PoseGraph) -> None: ...
def optimize(
    graph: PoseGraph,
    backend: str | BackEnd = "spa",
    *,
    loss: Loss = "mixture",
    loss_scale: float = 3.0,
    gnc: bool = True,
    init: Initialization = "auto",
    max_iterations: int = 100,
    cost_tolerance: float = 1e-7,
    max_solver_time_s: float = ...,
    settings: dict[str, str] = ...,
) -> tuple[PoseGraph, Summary]: ...
def list_backends() -> list[dict[str, Any]]: ...
def covariances(
    graph: PoseGraph, ids: npt.ArrayLike | None = None, summary: Summary | None = None
) -> Array: ...
def certify(graph: PoseGraph, *, descend: bool = False) -> tuple[PoseGraph, Certificate]: ...
def read_relations(path: Path) -> list[Relation]: ...
def evaluate_relations(
    relations: Sequence[Relation], trajectory: Trajectory, *, max_gap_s: float = 0.1
) -> RelationErrors: ...
def absolute_trajectory_error(
    truth: Trajectory,
    estimate: Trajectory,
    *,
    alignment: Literal["none", "first", "se2"] = "se2",
    max_gap_s: float = 0.01,
) -> PoseErrors: ...
def relative_pose_error(
    truth: Trajectory,
    estimate: Trajectory,
    *,
    step: float = 1.0,
    unit: Literal["frames", "m", "s"] = "frames",
    max_gap_s: float = 0.01,
) -> PoseErrors: ...
def simulate(
    world: OccupancyMap | Path,
    way_points: npt.ArrayLike,
    *,
    seed: int = 1,
    beams: int = 1000,
    fov_rad: float = ...,
    scan_rate_hz: float = 10.0,
    max_range_m: float = 30.0,
    range_noise_m: float = 0.015,
    robot_T_laser: npt.ArrayLike = (0.0, 0.0, 0.0),
    max_speed_m_s: float = 1.5,
    robot_radius_m: float = 0.5,
    odometry_noise: float = 1.0,
    interference: float = 1.0,
) -> SimulatedRun: ...
def read_way_points(path: Path) -> Array: ...
