// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/candidates.h"

#include <algorithm>
#include <cmath>

namespace gmapping_spa::loop_closure {

using backend::SE2;

std::vector<Candidate> FindCandidates(const CandidateOptions& options, const DriftModel& drift,
                                      const std::vector<SE2>& world_T_nodes,
                                      const std::vector<double>& ways_driven_m,
                                      const std::vector<double>& path_lengths_m, int node) {
  std::vector<std::pair<double, Candidate>> near;  // with the distance in terms of what is allowed
  for (int old = 0; old < node; ++old) {
    if (path_lengths_m[old] < options.min_path_length_m) continue;
    const double distance_m = Between(world_T_nodes[old], world_T_nodes[node]).translation().norm();
    const double allowed_m =
        options.max_distance_m +
        std::min(options.sigmas * drift.LinearSigma(path_lengths_m[old]), options.max_drift_m);
    if (distance_m <= allowed_m)
      near.push_back({distance_m / allowed_m, {old, path_lengths_m[old], distance_m}});
  }
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.old_node < b.second.old_node;
  });
  std::vector<Candidate> candidates;
  for (const auto& [_, candidate] : near) {
    if (static_cast<int>(candidates.size()) == options.max_candidates) break;
    const bool same_pass = std::any_of(
        candidates.begin(), candidates.end(), [&, old = candidate.old_node](const Candidate& c) {
          return std::abs(ways_driven_m[c.old_node] - ways_driven_m[old]) <
                 options.min_path_length_m / 2;
        });
    if (!same_pass) candidates.push_back(candidate);
  }
  return candidates;
}

}  // namespace gmapping_spa::loop_closure
