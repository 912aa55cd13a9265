// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/closure_set.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontend/loop_closure/consistent_set.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

namespace {

double WayBetween(const DrivenPath& path, int a, int b) {
  return std::abs(path.ways_driven_m[a] - path.ways_driven_m[b]);
}

// Whether the two closures put the node at different places.
bool AreElsewhere(const ProofOptions& options, const DrivenPath& path, const ClosureRecord& a,
                  const ClosureRecord& b, int node) {
  const SE2 off = Between(PredictedPose(path, a, node), PredictedPose(path, b, node));
  return off.translation().norm() > options.rival_m || std::abs(off.theta) > options.rival_rad;
}

// At most so many, spread evenly.
std::vector<std::size_t> Thinned(const std::vector<std::size_t>& members) {
  const std::size_t count = std::min<std::size_t>(members.size(), kMaxConsistentSet);
  std::vector<std::size_t> thinned;
  for (std::size_t k = 0; k < count; ++k) thinned.push_back(members[k * members.size() / count]);
  return thinned;
}

// Of the member that drift explains most easily.
double SmallestGate(const std::vector<ClosureRecord>& records,
                    const std::vector<std::size_t>& members) {
  double gate = std::numeric_limits<double>::infinity();
  for (const std::size_t member : members) gate = std::min(gate, records[member].mahalanobis_sq);
  return gate;
}

// The members out of the largest pairwise consistent subset; empty when that proves nothing over
// however much driving.
std::vector<std::size_t> SoundMembers(const ProofOptions& options, const DriftModel& drift,
                                      const DrivenPath& path,
                                      const std::vector<ClosureRecord>& records,
                                      const ClosureSet& set) {
  const int min_members = set.wheels_agree ? options.min_members_by_wheels : options.min_members;
  if (static_cast<int>(set.members.size()) < min_members) return {};
  const std::vector<std::size_t> all = Thinned(set.members);
  std::vector<std::size_t> members;
  for (const int k : LargestConsistentSet(static_cast<int>(all.size()), [&](int a, int b) {
         return AreConsistent(drift, options.consistent_sigmas, path, records[all[a]],
                              records[all[b]]);
       })) {
    members.push_back(all[k]);
  }
  const auto count = static_cast<int>(members.size());
  if (count < min_members) return {};
  if (count < options.min_per_contradiction * set.contradictions) return {};
  if (SmallestGate(records, members) > options.impossible_mahalanobis_sq) return {};
  return members;
}

// Around the loop through the members of both that are nearest to each other by driving.
bool Agree(const ProofOptions& options, const DriftModel& drift, const DrivenPath& path,
           const std::vector<ClosureRecord>& records, const std::vector<std::size_t>& a,
           const std::vector<std::size_t>& b) {
  const ClosureRecord *nearest_a = nullptr, *nearest_b = nullptr;
  double nearest_m = options.agree_within_m;
  for (const std::size_t i : a) {
    for (const std::size_t j : b) {
      const double path_length_m = WayBetween(path, records[i].node, records[j].node) +
                                   WayBetween(path, records[i].old_node, records[j].old_node);
      if (path_length_m > nearest_m) continue;
      nearest_m = path_length_m;
      nearest_a = &records[i];
      nearest_b = &records[j];
    }
  }
  return nearest_a != nullptr &&
         AreConsistent(drift, options.agree_sigmas, path, *nearest_a, *nearest_b);
}

}  // namespace

// Around the loop through both: a's old node -> a's node -> b's node -> b's old node -> a's.
bool AreConsistent(const DriftModel& drift, double sigmas, const DrivenPath& path,
                   const ClosureRecord& a, const ClosureRecord& b) {
  const SE2 around = a.old_T_node *
                     Between(path.world_T_nodes[a.node], path.world_T_nodes[b.node]) *
                     Inverse(b.old_T_node) *
                     Between(path.world_T_nodes[b.old_node], path.world_T_nodes[a.old_node]);
  const double path_length_m =
      WayBetween(path, a.node, b.node) + WayBetween(path, a.old_node, b.old_node);
  return drift.SquaredDistance(around, path_length_m) <= sigmas * sigmas;
}

double SpanOf(const DrivenPath& path, const std::vector<ClosureRecord>& records,
              const std::vector<std::size_t>& members) {
  if (members.empty()) return 0.0;
  const auto [first, last] = std::minmax_element(
      members.begin(), members.end(),
      [&](std::size_t a, std::size_t b) { return records[a].node < records[b].node; });
  return WayBetween(path, records[*first].node, records[*last].node);
}

double ProofOf(const ProofOptions& options, const DrivenPath& path,
               const std::vector<ClosureRecord>& records, const std::vector<std::size_t>& members) {
  if (members.empty()) return 0.0;
  const double variances = SmallestGate(records, members) / options.max_mahalanobis_sq;
  return SpanOf(path, records, members) /
         (options.min_span_m * std::sqrt(std::max(variances, 1.0)));
}

std::vector<std::vector<std::size_t>> ProvenSets(const ProofOptions& options,
                                                 const DriftModel& drift, const DrivenPath& path,
                                                 const std::vector<ClosureRecord>& records,
                                                 const std::vector<ClosureSet>& sets) {
  std::vector<std::vector<std::size_t>> sound;
  sound.reserve(sets.size());
  for (const ClosureSet& set : sets) {
    sound.push_back(SoundMembers(options, drift, path, records, set));
  }
  std::vector<std::vector<std::size_t>> proven(sets.size());
  for (std::size_t k = 0; k < sets.size(); ++k) {
    double proof = ProofOf(options, path, records, sound[k]);
    if (proof > 0.0 && sets[k].wheels_agree) proof += options.wheels_proof;
    std::vector<std::size_t> counted = {k};
    for (std::size_t other = 0; other < sets.size() && proof > 0.0 && proof < 1.0; ++other) {
      if (!Agree(options, drift, path, records, sound[k], sound[other])) continue;
      const bool is_new = std::none_of(counted.begin(), counted.end(), [&](std::size_t c) {
        return sets[c].first_node <= sets[other].last_node &&
               sets[other].first_node <= sets[c].last_node;
      });
      if (!is_new) continue;  // the same driving proves nothing twice
      proof += ProofOf(options, path, records, sound[other]);
      counted.push_back(other);
    }
    if (proof >= 1.0) proven[k] = sound[k];
  }
  return proven;
}

const ClosureRecord& NearestMember(const DrivenPath& path,
                                   const std::vector<ClosureRecord>& records, const ClosureSet& set,
                                   int node) {
  CHECK(!set.members.empty());
  return records[*std::min_element(
      set.members.begin(), set.members.end(), [&](std::size_t a, std::size_t b) {
        return WayBetween(path, records[a].node, node) < WayBetween(path, records[b].node, node);
      })];
}

SE2 PredictedPose(const DrivenPath& path, const ClosureRecord& member, int node) {
  return path.world_T_nodes[member.old_node] * member.old_T_node *
         Between(path.world_T_nodes[member.node], path.world_T_nodes[node]);
}

bool HasLikelierRival(const ProofOptions& options, const DrivenPath& path,
                      const std::vector<ClosureRecord>& records, const ClosureRecord& record) {
  return std::any_of(records.begin(), records.end(), [&](const ClosureRecord& rival) {
    const bool is_open =
        rival.verdict == Verdict::kUnconfirmed || rival.verdict == Verdict::kAccepted;
    return is_open && rival.source == Source::kNear &&
           rival.mahalanobis_sq < record.mahalanobis_sq - options.rival_mahalanobis_sq &&
           WayBetween(path, rival.node, record.node) <= options.rival_within_m &&
           AreElsewhere(options, path, record, rival, record.node);
  });
}

bool Contradict(const ProofOptions& options, const DrivenPath& path,
                const std::vector<ClosureRecord>& records, const ClosureSet& set,
                const ClosureSet& rival) {
  return std::any_of(set.members.begin(), set.members.end(), [&](std::size_t member) {
    const int node = records[member].node;
    if (node < rival.first_node || node > rival.last_node) return false;
    return AreElsewhere(options, path, records[member], NearestMember(path, records, rival, node),
                        node);
  });
}

}  // namespace gmapping_spa::loop_closure
