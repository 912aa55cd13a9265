#include "frontend/loop_closure/loop_closer.h"

#include <algorithm>
#include <cmath>

namespace gmapping_spa::loop_closure {

using backend::SE2;

LoopCloser::LoopCloser(const Options& options)
    : options_(options), verifier_(options.verifier, options.drift, options.candidates) {}

int LoopCloser::Update(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node) {
  const std::vector<double> ways_driven = WaysDriven(world_T_nodes);
  // What lies ahead of the node is part of what is matched.
  const auto ahead = std::upper_bound(ways_driven.begin(), ways_driven.end(),
                                      ways_driven.back() - options_.verifier.new_reach_m);
  const int node = static_cast<int>(ahead - ways_driven.begin()) - 1;
  if (node < 0 || ways_driven[node] < last_attempt_m_ + options_.attempt_every_m) return 0;
  last_attempt_m_ = ways_driven[node];
  return Attempt(world_T_nodes, ways_driven, scan_of_node, node);
}

int LoopCloser::UpdateAll(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node) {
  const std::vector<double> ways_driven = WaysDriven(world_T_nodes);
  double last_attempt_m = -options_.attempt_every_m;
  int accepted = 0;
  for (int node = 0; node < static_cast<int>(world_T_nodes.size()); ++node) {
    if (ways_driven[node] < last_attempt_m + options_.attempt_every_m) continue;
    last_attempt_m = ways_driven[node];
    accepted += Attempt(world_T_nodes, ways_driven, scan_of_node, node);
  }
  return accepted;
}

int LoopCloser::Attempt(const std::vector<SE2>& world_T_nodes,
                        const std::vector<double>& ways_driven, const ScanOfNode& scan_of_node,
                        int node) {
  const std::vector<double> ways = ShortestWays(ways_driven, closures_, node);
  int accepted = 0;
  for (const Candidate& candidate : FindCandidates(options_.candidates, options_.drift,
                                                   world_T_nodes, ways_driven, ways, node)) {
    records_.push_back(verifier_.Verify(world_T_nodes, scan_of_node, node, candidate));
    if (records_.back().verdict == Verdict::kUnconfirmed) {
      accepted += Confirm(world_T_nodes, ways_driven, records_.size() - 1);
    }
  }
  return accepted;
}

// Pairwise consistency (Mangelson et al. 2018, of pairs only): accepts the newest closure and those
// not yet confirmed with which it closes a short loop.
int LoopCloser::Confirm(const std::vector<SE2>& world_T_nodes,
                        const std::vector<double>& ways_driven, std::size_t newest) {
  ClosureRecord& a = records_[newest];
  int accepted = 0;
  for (std::size_t k = 0; k < newest; ++k) {
    ClosureRecord& b = records_[k];
    if (b.verdict != Verdict::kUnconfirmed && b.verdict != Verdict::kAccepted) continue;
    const double new_way = std::abs(ways_driven[a.node] - ways_driven[b.node]);
    const double old_way = std::abs(ways_driven[a.old_node] - ways_driven[b.old_node]);
    if (new_way > options_.confirm_within_m || old_way > options_.confirm_within_m) continue;
    if (new_way < options_.confirm_beyond_m) continue;
    // Around the loop: a's old node -> a's node -> b's node -> b's old node -> a's old node.
    const SE2 around = a.old_T_node * Between(world_T_nodes[a.node], world_T_nodes[b.node]) *
                       Inverse(b.old_T_node) *
                       Between(world_T_nodes[b.old_node], world_T_nodes[a.old_node]);
    const double squared = options_.drift.SquaredDistance(around, new_way + old_way);
    if (squared > options_.confirm_sigmas * options_.confirm_sigmas) continue;
    for (ClosureRecord* record : {&a, &b}) {
      if (record->verdict == Verdict::kAccepted || IsClosed(*record)) continue;
      Accept(record);
      ++accepted;
    }
  }
  return accepted;
}

// Whether the same two nodes have been looked at before, and accepted.
bool LoopCloser::IsClosed(const ClosureRecord& record) const {
  return std::any_of(closures_.begin(), closures_.end(), [&](const backend::Edge& closure) {
    return closure.i == record.old_node && closure.j == record.node;
  });
}

void LoopCloser::Accept(ClosureRecord* record) {
  record->verdict = Verdict::kAccepted;
  closures_.push_back({.i = record->old_node,
                       .j = record->node,
                       .i_T_j = record->old_T_node,
                       .information = record->information,
                       .kind = backend::EdgeKind::kLoopClosure});
}

}  // namespace gmapping_spa::loop_closure
