// SPDX-License-Identifier: BSD-3-Clause
// The final estimate, when all scans are in.
#ifndef GMAPPING_SPA_FRONTEND_FINAL_OPTIMIZATION_H_
#define GMAPPING_SPA_FRONTEND_FINAL_OPTIMIZATION_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "frontend/loop_closure/loop_closer.h"
#include "frontend/loop_closure/pieces.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/map/scan_insertion.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_poses.h"
#include "frontend/sensor/scan_archive.h"
#include "frontend/slam_result.h"

namespace gmapping_spa::frontend {

class FinalOptimization {
 public:
  struct Options {
    int closing_rounds = 2;  // of looking for closures everywhere, given what the last one found
    int review_rounds = 5;   // of letting go of closures that the graph contradicts
    int refine = 1;          // rounds; 0: none
    // A scan of which fewer beams fit, or that would move farther, stays where it is.
    double min_inliers = 0.5;
    double max_shift_m = 0.15;
    double max_shift_rad = 0.03;
    // Of the poses before they are refined: keeps them in place along a corridor.
    double unrefined_sigma_m = 0.05;
    double unrefined_sigma_rad = 0.01;
    // Of what refined scans say about the motion between nodes.
    double refined_sigma_m = 0.02;
    double refined_sigma_rad = 0.003;
    scan_matching::GaussNewton::Options gauss_newton;
    friend bool operator==(const Options&, const Options&) = default;
  };

  // Everything that a run has gathered; all must outlive the FinalOptimization.
  struct Run {
    const sensor::ScanArchive* scans;
    const std::vector<int>* node_scans;  // positions of the nodes' scans in the archive
    const ScanPoses* scan_poses;
    map::OccupancyGrid::Options grid;
    map::InsertionOptions insertion;
    const loop_closure::Pieces* pieces = nullptr;  // null: the path is all one
    // Poses of the first scans that are known: they stay, and make the map alone. Null: none.
    const backend::Trajectory* known = nullptr;
    // Of each scan, given the closures there are by then, whether it is drawn; null: all.
    std::function<std::vector<bool>()> drawn_scans = {};
    loop_closure::LoopCloser* loop_closer;  // null: no closures
    // The back end: nothing when it fails.
    std::function<std::optional<backend::PoseGraph>(const backend::PoseGraph&)> optimize;
  };

  FinalOptimization(const Options& options, Run run);

  // Closes loops everywhere, optimizes, refines, and makes the map from all scans that are drawn.
  // `path` is the graph without closures.
  SlamResult Finish(backend::PoseGraph path);

  // world_T_node, optimized with the closures that there are.
  std::vector<backend::SE2> OptimizedNodes(const backend::PoseGraph& path) const;

 private:
  bool Optimize(const backend::PoseGraph& path, backend::PoseGraph* graph) const;
  void OptimizeAndReview(const backend::PoseGraph& path, backend::PoseGraph* graph) const;
  backend::Trajectory FilledTrajectory(const backend::PoseGraph& graph) const;
  int KnownScans() const { return run_.known ? static_cast<int>(run_.known->size()) : 0; }
  void RefineScans(const std::vector<bool>& is_drawn, backend::Trajectory* trajectory) const;
  void UpdateOdometryEdges(const backend::Trajectory& trajectory, backend::PoseGraph* path) const;
  sensor::LaserScan ScanOfNode(int node) const { return run_.scans->Get((*run_.node_scans)[node]); }
  std::size_t RowOfNode(std::int64_t node) const { return rows_[run_.node_scans->at(node)]; }
  void Register(int position, const backend::Trajectory& trajectory, map::OccupancyGrid* map) const;

  Options options_;
  Run run_;
  scan_matching::GaussNewton gauss_newton_;
  std::vector<std::size_t> rows_;  // of the trajectory, of each position in the archive
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_FINAL_OPTIMIZATION_H_
