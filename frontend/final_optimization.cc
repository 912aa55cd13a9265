// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/final_optimization.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::frontend {

using backend::SE2;

FinalOptimization::FinalOptimization(const Options& options, Run run)
    : options_(options),
      run_(std::move(run)),
      gauss_newton_(options.gauss_newton),
      rows_(run_.scans->Rows()) {}

SlamResult FinalOptimization::Finish(backend::PoseGraph path) {
  backend::PoseGraph graph = path;
  OptimizeAndReview(path, &graph);
  const auto scan_of_node = [this](int node) { return ScanOfNode(node); };
  for (int round = 0; run_.loop_closer && round < options_.closing_rounds; ++round) {
    if (run_.loop_closer->UpdateAll(backend::PosesOf(graph), scan_of_node) == 0) break;
    OptimizeAndReview(path, &graph);
  }

  const std::vector<bool> is_drawn =
      run_.drawn_scans ? run_.drawn_scans() : std::vector<bool>(run_.scans->size(), true);
  backend::Trajectory trajectory = FilledTrajectory(graph);
  for (int round = 0; round < options_.refine; ++round) {
    if (round > 0) {
      UpdateOdometryEdges(trajectory, &path);
      Optimize(path, &graph);
      trajectory = FilledTrajectory(graph);
    }
    RefineScans(is_drawn, &trajectory);
    for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
      graph.nodes[node].world_T_node = trajectory[RowOfNode(node)].world_T_robot;
    }
  }

  map::OccupancyGrid map(run_.grid);
  const int scans_of_map = run_.known ? KnownScans() : run_.scans->size();
  for (int k = 0; k < scans_of_map; ++k) {
    if (is_drawn[k]) Register(k, trajectory, &map);
  }
  std::vector<bool> is_placed(is_drawn.size());
  for (int k = 0; k < run_.scans->size(); ++k) is_placed[rows_[k]] = is_drawn[k];
  return {std::move(graph), std::move(trajectory), std::move(map), std::move(is_placed)};
}

std::vector<SE2> FinalOptimization::OptimizedNodes(const backend::PoseGraph& path) const {
  backend::PoseGraph graph = path;
  Optimize(path, &graph);
  return backend::PosesOf(graph);
}

backend::Trajectory FinalOptimization::FilledTrajectory(const backend::PoseGraph& graph) const {
  backend::Trajectory trajectory = run_.scan_poses->Fill(backend::PosesOf(graph));
  if (run_.known) std::copy(run_.known->begin(), run_.known->end(), trajectory.begin());
  return trajectory;
}

// Optimizes the path with all closures, from the poses that `graph` has. They stay when the back
// end fails. Returns whether it moved them.
bool FinalOptimization::Optimize(const backend::PoseGraph& path, backend::PoseGraph* graph) const {
  graph->edges = path.edges;
  if (run_.loop_closer) {
    const std::vector<backend::Edge>& closures = run_.loop_closer->closures();
    graph->edges.insert(graph->edges.end(), closures.begin(), closures.end());
    if (run_.pieces) run_.pieces->Arrange(closures, graph);
  }
  const std::optional<backend::PoseGraph> optimized = run_.optimize(*graph);
  if (!optimized || backend::PosesOf(*optimized) == backend::PosesOf(*graph)) return false;
  *graph = *optimized;
  return true;
}

// Lets go of closures that the rest of the graph contradicts, until there are none. A back end that
// moved nothing contradicts nothing.
void FinalOptimization::OptimizeAndReview(const backend::PoseGraph& path,
                                          backend::PoseGraph* graph) const {
  if (!Optimize(path, graph) || !run_.loop_closer) return;
  for (int round = 0; round < options_.review_rounds; ++round) {
    if (run_.loop_closer->Review(backend::PosesOf(*graph)) == 0) break;
    Optimize(path, graph);
  }
}

// Aligns every scan with the map that the nodes' scans make: for the scans in between, a map made
// of all others. That map is sharper than one of all scans, and made in a tenth of the time.
void FinalOptimization::RefineScans(const std::vector<bool>& is_drawn,
                                    backend::Trajectory* trajectory) const {
  const Eigen::Matrix3d prior =
      backend::InformationFromSigmas(options_.unrefined_sigma_m, options_.unrefined_sigma_rad);
  map::OccupancyGrid map(run_.grid);
  for (const int position : *run_.node_scans) {
    if (is_drawn[position]) Register(position, *trajectory, &map);
  }
  for (int k = KnownScans(); k < run_.scans->size(); ++k) {
    if (!is_drawn[k]) continue;
    const sensor::LaserScan scan = run_.scans->Get(k);
    const scan_matching::ScanPoints points = scan_matching::MakeScanPoints(scan);
    SE2& pose = (*trajectory)[rows_[k]].world_T_robot;
    const scan_matching::GaussNewton::Alignment aligned =
        gauss_newton_.Align(map, points, pose, prior);
    const SE2 shift = Between(pose, aligned.world_T_robot);
    if (aligned.inliers >= options_.min_inliers * static_cast<double>(points.size()) &&
        shift.translation().norm() <= options_.max_shift_m &&
        std::abs(shift.theta) <= options_.max_shift_rad) {
      pose = aligned.world_T_robot;
    }
  }
}

// Replaces what the edges of the path measure by what the refined scans say.
void FinalOptimization::UpdateOdometryEdges(const backend::Trajectory& trajectory,
                                            backend::PoseGraph* path) const {
  for (backend::Edge& edge : path->edges) {
    if (run_.pieces && run_.pieces->BeginsAt(static_cast<int>(edge.j))) continue;
    const auto pose = [&](std::int64_t node) { return trajectory[RowOfNode(node)].world_T_robot; };
    edge.i_T_j = Between(pose(edge.i), pose(edge.j));
    edge.information =
        backend::InformationFromSigmas(options_.refined_sigma_m, options_.refined_sigma_rad);
  }
}

void FinalOptimization::Register(int position, const backend::Trajectory& trajectory,
                                 map::OccupancyGrid* map) const {
  map::InsertScan(run_.scans->Get(position), trajectory[rows_[position]].world_T_robot,
                  run_.insertion, map);
}

}  // namespace gmapping_spa::frontend
