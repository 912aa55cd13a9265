# SPDX-License-Identifier: BSD-3-Clause
# For type checkers alone: a part of __init__.pyi.
from typing import Literal

Loss = Literal["none", "huber", "cauchy", "dcs", "truncated", "mixture"]
Initialization = Literal["auto", "keep", "odometry", "spanning_tree", "chordal"]

class SlamOptions:
    def __init__(
        self,
        *,
        particles: int = ...,
        seed: int = ...,
        threads: int = ...,
        linear_update_m: float = ...,
        angular_update_rad: float = ...,
        resample_threshold: float = ...,
        obs_sigma_gain: float = ...,
        max_speed_m_s: float = ...,
        max_turn_rad_s: float = ...,
        sweep_duration_s: float | None = ...,
        motion_linear_per_linear: float = ...,
        motion_lateral_per_linear: float = ...,
        motion_linear_per_angular: float = ...,
        motion_angular_per_linear: float = ...,
        motion_angular_per_angular: float = ...,
        motion_linear_floor_m: float = ...,
        motion_angular_floor_rad: float = ...,
        odometry: Literal["raw", "wheel", "lidar", "lidar_only"] = ...,
        motion_noise: Literal["update", "scan"] = ...,
        resolution_m: float = ...,
        grid_occupied_threshold: float = ...,
        occupied_threshold: float = ...,
        no_return_clears: bool = ...,
        initial_guesses: int = ...,
        match_linear_step_m: float = ...,
        match_angular_step_rad: float = ...,
        match_refinements: int = ...,
        match_noise_m: float = ...,
        match_robust_sigmas: float = ...,
        match_min_score: float = ...,
        score_sigma_m: float = ...,
        free_cell_in_front: bool = ...,
        likelihood_sigma_m: float = ...,
        likelihood_gain: float = ...,
        unseen_is_miss: bool = ...,
        unmatched_sigmas: float = ...,
        scan_matcher: Literal["hill_climbing", "gauss_newton"] = ...,
        match_start: Literal["prediction", "draw"] = ...,
        proposal: Literal["gaussian", "match"] = ...,
        likelihood: Literal["surface", "nearest_hit"] = ...,
        loop_closure: bool = ...,
        closure_min_path_length_m: float = ...,
        closure_max_distance_m: float = ...,
        closure_drift_m_per_m: float = ...,
        closure_drift_rad_per_m: float = ...,
        closure_everywhere: bool = ...,
        closure_min_score: float = ...,
        closure_max_runner_up_score: float = ...,
        closure_min_overlap: float = ...,
        closure_min_inlier_ratio: float = ...,
        closure_information_gain: float = ...,
        gnc: bool = ...,
        optimize_every: int = ...,
        lockstep_scans: int = ...,
        graph_timeout_s: float = ...,
        final_optimization: bool = ...,
        refine: int = ...,
        edge_measurement: Literal["lidar_odometry", "particle"] = ...,
        edge_information: Literal["proposal", "hessian", "constant"] = ...,
        graph_thread: Literal["lockstep", "async", "inline"] = ...,
        correction: Literal["pose", "trajectory"] = ...,
        backend: str = ...,
        max_iterations: int = ...,
        cost_tolerance: float = ...,
        max_solver_time_s: float = ...,
        settings: dict[str, str] = ...,
        loss_scale: float = ...,
        loss: Loss = ...,
        init: Initialization = ...,
    ) -> None: ...
    particles: int
    seed: int
    threads: int
    linear_update_m: float
    angular_update_rad: float
    resample_threshold: float
    obs_sigma_gain: float
    max_speed_m_s: float
    max_turn_rad_s: float
    sweep_duration_s: float | None
    motion_linear_per_linear: float
    motion_lateral_per_linear: float
    motion_linear_per_angular: float
    motion_angular_per_linear: float
    motion_angular_per_angular: float
    motion_linear_floor_m: float
    motion_angular_floor_rad: float
    odometry: Literal["raw", "wheel", "lidar", "lidar_only"]
    motion_noise: Literal["update", "scan"]
    resolution_m: float
    grid_occupied_threshold: float
    occupied_threshold: float
    no_return_clears: bool
    initial_guesses: int
    match_linear_step_m: float
    match_angular_step_rad: float
    match_refinements: int
    match_noise_m: float
    match_robust_sigmas: float
    match_min_score: float
    score_sigma_m: float
    free_cell_in_front: bool
    likelihood_sigma_m: float
    likelihood_gain: float
    unseen_is_miss: bool
    unmatched_sigmas: float
    scan_matcher: Literal["hill_climbing", "gauss_newton"]
    match_start: Literal["prediction", "draw"]
    proposal: Literal["gaussian", "match"]
    likelihood: Literal["surface", "nearest_hit"]
    loop_closure: bool
    closure_min_path_length_m: float
    closure_max_distance_m: float
    closure_drift_m_per_m: float
    closure_drift_rad_per_m: float
    closure_everywhere: bool
    closure_min_score: float
    closure_max_runner_up_score: float
    closure_min_overlap: float
    closure_min_inlier_ratio: float
    closure_information_gain: float
    gnc: bool
    optimize_every: int
    lockstep_scans: int
    graph_timeout_s: float
    final_optimization: bool
    refine: int
    edge_measurement: Literal["lidar_odometry", "particle"]
    edge_information: Literal["proposal", "hessian", "constant"]
    graph_thread: Literal["lockstep", "async", "inline"]
    correction: Literal["pose", "trajectory"]
    backend: str
    max_iterations: int
    cost_tolerance: float
    max_solver_time_s: float
    settings: dict[str, str]
    loss_scale: float
    loss: Loss
    init: Initialization
    @staticmethod
    def improved() -> SlamOptions: ...
    @staticmethod
    def plain_gmapping() -> SlamOptions: ...
    @staticmethod
    def paper() -> SlamOptions: ...
    def copy(self) -> SlamOptions: ...
