// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/rival_search.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "frontend/loop_closure/drift.h"
#include "frontend/scan_matching/joined_points.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

// Nodes as near to where the closure has the node as that, the nearest one of each pass.
std::vector<int> RivalSearch::PlacesAround(const std::vector<SE2>& world_T_nodes, int node,
                                           const SE2& world_T_found, double reach_m) const {
  const std::vector<double> ways = WaysDriven(world_T_nodes);
  std::vector<std::pair<double, int>> near;
  for (int old = 0; old < static_cast<int>(world_T_nodes.size()); ++old) {
    if (std::abs(ways[old] - ways[node]) < options_.min_way_m) continue;
    const double distance_m =
        (world_T_nodes[old].translation() - world_T_found.translation()).norm();
    if (distance_m <= reach_m) near.push_back({distance_m, old});
  }
  std::sort(near.begin(), near.end());
  std::vector<int> places;
  for (const auto& [_, old] : near) {
    const bool is_seen = std::any_of(places.begin(), places.end(), [&, old = old](int place) {
      return std::abs(ways[place] - ways[old]) < options_.old_reach_m;
    });
    if (!is_seen) places.push_back(old);
  }
  return places;
}

bool RivalSearch::HasRival(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                           const ClosureRecord& record) const {
  const SE2 world_T_found = world_T_nodes[record.old_node] * record.old_T_node;
  const auto way_to = [&](const SE2& world_T_node) {
    return (world_T_node.translation() - world_T_found.translation()).norm();
  };
  const double moved_m = way_to(world_T_nodes[record.node]);
  if (moved_m < options_.elsewhere_m) return false;
  const double reach_m = std::min(4.0 * moved_m, options_.max_reach_m);
  const std::vector<Eigen::Vector2d> points = scan_matching::PositionsOf(JoinScans(
      world_T_nodes, scan_of_node, NodesAround(world_T_nodes, record.node, options_.new_reach_m),
      record.node, options_.cell_m));
  scan_matching::CorrelativeMatcher::Options search = options_.search;
  search.min_score = options_.max_runner_up_score * record.score;
  // The best one may be better than the closure, and the second as good.
  search.runner_up_floor =
      std::min(options_.max_runner_up_score * options_.max_runner_up_score, 1.0);
  search.peak_separation_m = options_.elsewhere_m;
  search.with_covariance = false;
  for (const int place : PlacesAround(world_T_nodes, record.node, world_T_found, reach_m)) {
    const scan_matching::CorrelativeMatcher matcher(
        search,
        scan_matching::PositionsOf(JoinScans(
            world_T_nodes, scan_of_node, NodesAround(world_T_nodes, place, options_.old_reach_m),
            place, options_.cell_m)));
    const scan_matching::CorrelativeMatch match = matcher.Match(
        points, Between(world_T_nodes[place], world_T_found), {reach_m, options_.max_turn_rad});
    if (!match.found) continue;
    const auto is_rival = [&](const SE2& place_T_node, double score) {
      const double apart_m = way_to(world_T_nodes[place] * place_T_node);
      return score >= search.min_score && apart_m >= options_.elsewhere_m && apart_m < reach_m;
    };
    if (is_rival(match.map_T_scan, match.score) ||
        is_rival(match.runner_up_map_T_scan, match.runner_up_score)) {
      return true;
    }
  }
  return false;
}

}  // namespace gmapping_spa::loop_closure
