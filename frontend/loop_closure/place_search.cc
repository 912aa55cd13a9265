// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/place_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "frontend/scan_matching/joined_points.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

namespace {

std::vector<Eigen::Vector2d> ToDouble(const std::vector<Eigen::Vector2f>& points) {
  std::vector<Eigen::Vector2d> result;
  result.reserve(points.size());
  for (const Eigen::Vector2f& point : points) result.push_back(point.cast<double>());
  return result;
}

std::vector<Eigen::Vector2f> ToFloat(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2f> result;
  result.reserve(points.size());
  for (const Eigen::Vector2d& point : points) result.push_back(point.cast<float>());
  return result;
}

}  // namespace

void PlaceSearch::Add(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                      int node) {
  const NodeRange nodes = NodesAround(world_T_nodes, node, options_.reach_m);
  std::vector<Eigen::Vector2d> points;
  for (const scan_matching::ScanPoint& point :
       JoinScans(world_T_nodes, scan_of_node, nodes, node, options_.cell_m)) {
    const Eigen::Vector2d at(point.x_m, point.y_m);
    if (at.norm() < kDescriptorRadius_m) points.push_back(at);
  }
  Place place{node, {}, ComputeDescriptor(points), IsDistinct(points)};
  if (place.is_distinct) place.points = ToFloat(points);
  places_.push_back(std::move(place));
}

// Whether a shift leaves too much as it is, as in a corridor.
bool PlaceSearch::IsDistinct(const std::vector<Eigen::Vector2d>& points) const {
  if (points.empty()) return false;
  scan_matching::CorrelativeMatcher::Options options = options_.search;
  options.runner_up_floor = 0.9 * options_.max_likeness;
  const scan_matching::CorrelativeMatcher search(options, points);
  const scan_matching::CorrelativeMatch match = search.Match(
      scan_matching::Thinned(points, options_.max_points), SE2{}, {options_.window_m, 0.0});
  return match.found && match.runner_up_score <= options_.max_likeness * match.score;
}

std::vector<const PlaceSearch::Place*> PlaceSearch::Shortlist(
    int place, const std::vector<double>& ways_driven_m,
    const std::function<bool(int node)>& may_match) const {
  std::vector<std::pair<double, const Place*>> ranked;
  for (int k = 0; k < place; ++k) {
    if (!places_[k].is_distinct || !may_match(places_[k].node)) continue;
    ranked.push_back(
        {Dissimilarity(places_[k].descriptor, places_[place].descriptor), &places_[k]});
  }
  std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second->node < b.second->node;
  });
  std::vector<const Place*> shortlist;
  for (const auto& [_, old] : ranked) {
    if (static_cast<int>(shortlist.size()) == options_.shortlist) break;
    const bool is_near =
        std::any_of(shortlist.begin(), shortlist.end(), [&, node = old->node](const Place* other) {
          return std::abs(ways_driven_m[other->node] - ways_driven_m[node]) < options_.apart_m;
        });
    if (!is_near) shortlist.push_back(old);
  }
  return shortlist;
}

std::vector<PlaceMatch> PlaceSearch::Find(int place, const std::vector<double>& ways_driven_m,
                                          const std::function<bool(int node)>& may_match) const {
  std::vector<PlaceMatch> matches;
  if (!places_.at(place).is_distinct) return matches;
  const std::vector<Eigen::Vector2d> points =
      scan_matching::Thinned(ToDouble(places_[place].points), options_.max_points);
  for (const Place* old : Shortlist(place, ways_driven_m, may_match)) {
    const scan_matching::CorrelativeMatcher search(options_.search, ToDouble(old->points));
    const scan_matching::CorrelativeMatch match =
        search.Match(points, SE2{}, {options_.window_m, std::numbers::pi});
    if (!match.found) continue;
    matches.push_back({old->node, match.map_T_scan, match.score, match.runner_up_score});
  }
  return matches;
}

}  // namespace gmapping_spa::loop_closure
