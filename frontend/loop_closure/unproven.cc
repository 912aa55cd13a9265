// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/unproven.h"

#include <algorithm>
#include <cmath>

namespace gmapping_spa::loop_closure {

using backend::SE2;

std::vector<UnprovenClosure> UnprovenClosures(const UnprovenOptions& options,
                                              const DriftModel& drift, const DrivenPath& path,
                                              std::span<const backend::Edge> closures,
                                              const std::vector<ClosureRecord>& records) {
  const std::vector<double>& ways = path.ways_driven_m;
  const auto is_open = [](const ClosureRecord& record) {
    return record.verdict == Verdict::kUnconfirmed || record.verdict == Verdict::kRival;
  };
  const auto is_settled = [&](int node) {
    return std::any_of(closures.begin(), closures.end(), [&](const backend::Edge& closure) {
      return std::abs(ways[closure.i] - ways[node]) <= options.settled_m ||
             std::abs(ways[closure.j] - ways[node]) <= options.settled_m;
    });
  };
  const auto agrees = [&](const ClosureRecord& a, const ClosureRecord& b) {
    const double apart_m = std::abs(ways[a.node] - ways[b.node]);
    return apart_m >= options.apart_m && apart_m <= options.within_m &&
           AreConsistent(drift, options.proof.consistent_sigmas, path, a, b);
  };
  std::vector<UnprovenClosure> unproven;
  for (const ClosureRecord& record : records) {
    if (!is_open(record) || is_settled(record.node)) continue;
    const SE2 off =
        Between(Between(path.world_T_nodes[record.old_node], path.world_T_nodes[record.node]),
                record.old_T_node);
    const double moved_m = off.translation().norm();
    const double way_m = ShortestWays(ways, closures, record.node)[record.old_node];
    if (moved_m <= options.proof.rival_m || way_m >= kUnknownWay_m ||
        drift.SquaredDistance(off, way_m) > options.proof.max_mahalanobis_sq)
      continue;
    const bool has_second = std::any_of(
        records.begin(), records.end(),
        [&](const ClosureRecord& other) { return is_open(other) && agrees(record, other); });
    if (has_second) unproven.push_back({record.node, moved_m});
  }
  std::stable_sort(unproven.begin(), unproven.end(),
                   [](const auto& a, const auto& b) { return a.moved_m > b.moved_m; });
  return unproven;
}

}  // namespace gmapping_spa::loop_closure
