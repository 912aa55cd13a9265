// SPDX-License-Identifier: BSD-3-Clause
// What somebody who looks at the map knows better.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>

#include "frontend/loop_closure/loop_closer.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

namespace {

// Around the estimate, at least: where it is right, local maps overlap well before the border.
constexpr double kLeastWindow_m = 3.0;

// Nodes so near to each other on the way see the same.
constexpr int kSameLook_nodes = 1;

}  // namespace

int LoopCloser::Edit(const std::vector<ClosureRecord>& edited) {
  using Key = std::tuple<int, int, Source>;
  const auto key_of = [](const ClosureRecord& record) {
    return Key{record.old_node, record.node, record.source};
  };
  std::multimap<Key, const ClosureRecord*> open;  // equal ones stay in order
  for (const ClosureRecord& record : edited) open.emplace(key_of(record), &record);
  int without_own = 0;
  for (ClosureRecord& record : records_) {
    if (const auto own = open.find(key_of(record)); own != open.end()) {
      // Their scores are rounded in files, and decide about others.
      record.old_T_node = own->second->old_T_node;
      record.information = own->second->information;
      record.verdict = own->second->verdict;
      record.overruled_verdict = own->second->overruled_verdict;
      record.is_by_hand = own->second->is_by_hand;
      open.erase(own);
    } else if (record.verdict == Verdict::kAccepted) {
      record.overruled_verdict = std::exchange(record.verdict, Verdict::kRejected);
      record.is_by_hand = true;
      ++without_own;
    }
  }
  for (const ClosureRecord& record : edited) {
    const auto [begin, end] = open.equal_range(key_of(record));
    const auto own = std::find_if(begin, end, [&](const auto& e) { return e.second == &record; });
    if (own != end) records_.push_back(record);
  }
  accepted_.clear();
  closures_.clear();
  for (std::size_t position = 0; position < records_.size(); ++position) {
    if (records_[position].verdict == Verdict::kAccepted) Accept(position);
  }
  return without_own;
}

ClosureRecord LoopCloser::Measure(const std::vector<SE2>& estimate, const ScanOfNode& scan_of_node,
                                  int old_node, int node) const {
  const std::vector<SE2> world_T_nodes = InSight(estimate);
  const std::vector<double> ways = ShortestWays(WaysAcrossPieces(estimate), closures_, node);
  const SE2 old_T_node = Between(world_T_nodes[old_node], world_T_nodes[node]);
  const Candidate candidate{old_node, ways[old_node], old_T_node.translation().norm()};
  scan_matching::SearchWindow window = verifier_.WindowOf(candidate.path_length_m);
  window.linear_m = std::max(window.linear_m, kLeastWindow_m);
  const scan_matching::SearchWindow largest{options_.candidates.max_drift_m,
                                            options_.verifier.max_turn_rad};
  ClosureRecord record;
  for (const scan_matching::SearchWindow& searched : {window, largest}) {
    record =
        verifier_.VerifyAt(world_T_nodes, scan_of_node, node, candidate, {old_T_node, searched});
    if (record.verdict == Verdict::kUnconfirmed || record.verdict == Verdict::kRival) break;
  }
  record.source = Source::kHand;
  return record;
}

bool LoopCloser::IsRejectedByHand(const ClosureRecord& record) const {
  if (record.is_by_hand) return false;
  const auto is_near = [this](int a, int b) { return std::abs(a - b) <= kSameLook_nodes; };
  return std::any_of(records_.begin(), records_.end(), [&](const ClosureRecord& other) {
    return other.verdict == Verdict::kRejected && is_near(other.old_node, record.old_node) &&
           is_near(other.node, record.node);
  });
}

}  // namespace gmapping_spa::loop_closure
