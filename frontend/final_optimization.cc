// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/final_optimization.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::frontend {

using backend::SE2;

FinalOptimization::FinalOptimization(const Options& options, Run run)
    : options_(options), run_(std::move(run)), gauss_newton_(options.gauss_newton) {
  std::vector<int> positions(run_.scans->size());
  std::iota(positions.begin(), positions.end(), 0);
  std::sort(positions.begin(), positions.end(),
            [this](int a, int b) { return run_.scans->IndexOf(a) < run_.scans->IndexOf(b); });
  rows_.resize(positions.size());
  for (int row = 0; row < run_.scans->size(); ++row) rows_[positions[row]] = row;
}

SlamResult FinalOptimization::Finish(backend::PoseGraph path) {
  backend::PoseGraph graph = path;
  OptimizeAndReview(path, &graph);
  const auto scan_of_node = [this](int node) { return ScanOfNode(node); };
  for (int round = 0; run_.loop_closer && round < options_.closing_rounds; ++round) {
    if (run_.loop_closer->UpdateAll(backend::PosesOf(graph), scan_of_node) == 0) break;
    OptimizeAndReview(path, &graph);
  }

  const std::vector<bool> is_drawn = DrawnScans(static_cast<int>(graph.nodes.size()));
  backend::Trajectory trajectory = run_.scan_poses->Fill(backend::PosesOf(graph));
  for (int round = 0; round < options_.refine; ++round) {
    if (round > 0) {
      UpdateOdometryEdges(trajectory, &path);
      Optimize(path, &graph);
      trajectory = run_.scan_poses->Fill(backend::PosesOf(graph));
    }
    RefineScans(is_drawn, &trajectory);
    for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
      graph.nodes[node].world_T_node = trajectory[RowOfNode(node)].world_T_robot;
    }
  }

  map::OccupancyGrid map(run_.grid);
  for (int k = 0; k < run_.scans->size(); ++k) {
    if (is_drawn[k]) Register(k, trajectory, &map);
  }
  return {std::move(graph), std::move(trajectory), std::move(map)};
}

std::vector<SE2> FinalOptimization::OptimizedNodes(const backend::PoseGraph& path) const {
  backend::PoseGraph graph = path;
  Optimize(path, &graph);
  return backend::PosesOf(graph);
}

// Of each scan whether it fits, and belongs to the largest pieces that are joined.
std::vector<bool> FinalOptimization::DrawnScans(int nodes) const {
  std::vector<bool> is_drawn(run_.scans->size(), true);
  if (run_.pieces) {
    const std::vector<bool> largest = run_.pieces->Largest(
        nodes, run_.loop_closer ? run_.loop_closer->closures() : std::vector<backend::Edge>());
    int node = 0;  // the last one up to the scan
    for (int k = 0; k < run_.scans->size(); ++k) {
      if (node + 1 < nodes && run_.node_scans->at(node + 1) <= k) ++node;
      is_drawn[k] = largest[run_.pieces->PieceOf(node)];
    }
  }
  for (int k = 0; run_.is_lost && k < run_.scans->size(); ++k) {
    is_drawn[k] = is_drawn[k] && !(*run_.is_lost)[k];
  }
  return is_drawn;
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
  for (int k = 0; k < run_.scans->size(); ++k) {
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
