// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/loop_closer.h"

#include <algorithm>
#include <cmath>

#include "backend/cost/edge_error.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

LoopCloser::LoopCloser(const Options& options)
    : options_(options),
      verifier_(options.verifier, options.drift, options.candidates),
      global_(options.global, verifier_, options.drift, options.candidates) {}

int LoopCloser::Update(const std::vector<SE2>& estimate, const ScanOfNode& scan_of_node) {
  const std::vector<double> ways_driven = WaysAcrossPieces(estimate);
  const std::vector<SE2> world_T_nodes = InSight(estimate);
  int accepted = 0;
  if (options_.search_everywhere) {
    accepted += Follow(global_.Update({world_T_nodes, ways_driven},
                                      InSight(estimate, Pieces::Sight::kWheels), scan_of_node,
                                      closures_, &records_));
  }
  // What lies ahead of the node is part of what is matched.
  const auto ahead = std::upper_bound(ways_driven.begin(), ways_driven.end(),
                                      ways_driven.back() - options_.verifier.new_reach_m);
  const int node = static_cast<int>(ahead - ways_driven.begin()) - 1;
  if (node < 0 || ways_driven[node] < last_search_m_ + options_.search_every_m) {
    return accepted;
  }
  last_search_m_ = ways_driven[node];
  return accepted + SearchNear(world_T_nodes, ways_driven, scan_of_node, node);
}

int LoopCloser::UpdateAll(const std::vector<SE2>& estimate, const ScanOfNode& scan_of_node) {
  const std::vector<double> ways_driven = WaysAcrossPieces(estimate);
  const std::vector<SE2> world_T_nodes = InSight(estimate);
  double last_search_m = -options_.search_every_m;
  int accepted = 0;
  for (int node = 0; node < static_cast<int>(world_T_nodes.size()); ++node) {
    if (ways_driven[node] < last_search_m + options_.search_every_m) continue;
    last_search_m = ways_driven[node];
    accepted += SearchNear(world_T_nodes, ways_driven, scan_of_node, node);
  }
  if (options_.search_everywhere) {
    accepted += Follow(global_.Finish({world_T_nodes, ways_driven},
                                      InSight(estimate, Pieces::Sight::kWheels), scan_of_node,
                                      closures_, &records_));
  }
  return accepted;
}

std::vector<double> LoopCloser::WaysAcrossPieces(const std::vector<SE2>& world_T_nodes) const {
  std::vector<double> ways = WaysDriven(world_T_nodes);
  for (int piece = 1; piece < pieces_.size(); ++piece) {
    const int first = pieces_.FirstNode(piece);
    // The same however corrections move the pieces.
    const double more_m = kUnknownWay_m - (ways[first] - ways[first - 1]);
    for (std::size_t k = first; k < ways.size(); ++k) ways[k] += more_m;
  }
  return ways;
}

// Poses of which those are near each other that are known to be.
std::vector<SE2> LoopCloser::InSight(const std::vector<SE2>& world_T_nodes,
                                     Pieces::Sight sight) const {
  std::vector<SE2> poses = world_T_nodes;
  if (pieces_.size() > 1) {
    pieces_.Arrange(closures_, &poses);
    pieces_.Separate(closures_, sight, &poses);
  }
  return poses;
}

int LoopCloser::Follow(const GlobalCloser::Decisions& decisions) {
  int changed = 0;
  for (const std::size_t position : decisions.release) changed += Release(position) ? 1 : 0;
  const auto accept = [&](const std::vector<std::size_t>& positions, bool restore) {
    for (const std::size_t position : positions) {
      const ClosureRecord& record = records_[position];
      const bool is_open = record.verdict == Verdict::kUnconfirmed ||
                           (restore && record.verdict == Verdict::kReleased);
      if (!is_open || IsClosed(record)) continue;
      Accept(position);
      ++changed;
    }
  };
  accept(decisions.restore, true);
  // Those of a believed set that Review has released come back when it says so.
  accept(decisions.accept, false);
  return changed;
}

int LoopCloser::Review(const std::vector<SE2>& world_T_nodes) {
  const auto squared_error = [&](const ClosureRecord& record) {
    const Eigen::Vector3d error = backend::EdgeError(world_T_nodes[record.old_node],
                                                     world_T_nodes[record.node], record.old_T_node);
    return error.dot(record.information * error);
  };
  double largest = 0.0;
  for (const std::size_t position : accepted_) {
    if (records_[position].is_by_hand) continue;
    largest = std::max(largest, squared_error(records_[position]));
  }
  // What is wrong bends what is right: those with small errors get another chance.
  const double limit = std::max(options_.max_squared_error, 0.25 * largest);
  int changed = 0;
  for (std::size_t position = 0; position < records_.size(); ++position) {
    const ClosureRecord& record = records_[position];
    if (record.verdict == Verdict::kAccepted && squared_error(record) > limit) {
      changed += Release(position) ? 1 : 0;
    } else if (record.verdict == Verdict::kReleased && !IsClosed(record) &&
               squared_error(record) <= 0.25 * options_.max_squared_error) {
      Accept(position);
      ++changed;
    }
  }
  return changed;
}

std::vector<UnprovenClosure> LoopCloser::Unproven(const std::vector<SE2>& estimate) const {
  const std::vector<double> ways_driven = WaysAcrossPieces(estimate);
  const std::vector<SE2> world_T_nodes = InSight(estimate);
  return UnprovenClosures({.apart_m = options_.confirm_beyond_m,
                           .within_m = options_.confirm_within_m,
                           .settled_m = options_.global.settled_m,
                           .proof = options_.global.proof},
                          options_.drift, {world_T_nodes, ways_driven}, closures_, records_);
}

void LoopCloser::TakeBackLocalization() {
  const auto latest =
      std::find_if(records_.rbegin(), records_.rend(),
                   [](const ClosureRecord& record) { return record.source == Source::kLocalized; });
  if (latest == records_.rend()) return;
  const int piece = pieces_.PieceOf(latest->node);
  for (std::size_t position = records_.rend() - latest - 1; position < records_.size();
       ++position) {
    ClosureRecord& record = records_[position];
    if (pieces_.PieceOf(record.node) != piece || pieces_.PieceOf(record.old_node) == piece) {
      continue;
    }
    if (Release(position)) record.verdict = Verdict::kInlierRatio;
  }
}

int LoopCloser::SearchNear(const std::vector<SE2>& world_T_nodes,
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
  const DrivenPath path{world_T_nodes, ways_driven};
  const ClosureRecord& a = records_[newest];
  int accepted = 0;
  if (HasLikelierRival(options_.global.proof, path, records_, a)) return accepted;
  for (std::size_t k = 0; k < newest; ++k) {
    const ClosureRecord& b = records_[k];
    if (b.source != Source::kNear && b.verdict != Verdict::kAccepted) continue;  // needs more proof
    if (b.verdict != Verdict::kUnconfirmed && b.verdict != Verdict::kAccepted) continue;
    const double new_way = std::abs(ways_driven[a.node] - ways_driven[b.node]);
    const double old_way = std::abs(ways_driven[a.old_node] - ways_driven[b.old_node]);
    if (new_way > options_.confirm_within_m || old_way > options_.confirm_within_m) continue;
    if (new_way < ConfirmBeyond(a, b)) continue;
    // Around the loop: a's old node -> a's node -> b's node -> b's old node -> a's old node.
    const SE2 around = a.old_T_node * Between(world_T_nodes[a.node], world_T_nodes[b.node]) *
                       Inverse(b.old_T_node) *
                       Between(world_T_nodes[b.old_node], world_T_nodes[a.old_node]);
    const double squared = options_.drift.SquaredDistance(around, new_way + old_way);
    if (squared > options_.confirm_sigmas * options_.confirm_sigmas) continue;
    if (HasLikelierRival(options_.global.proof, path, records_, b)) continue;
    for (const std::size_t position : {newest, k}) {
      const ClosureRecord& record = records_[position];
      if (record.verdict == Verdict::kAccepted || IsClosed(record)) continue;
      Accept(position);
      ++accepted;
    }
  }
  return accepted;
}

// An obstacle that was mistaken for another one stays so while it is in sight: looks at the same
// one agree, and the more so the more there is in the window to mistake it for.
double LoopCloser::ConfirmBeyond(const ClosureRecord& a, const ClosureRecord& b) const {
  if (a.verdict == Verdict::kAccepted || b.verdict == Verdict::kAccepted) {
    return options_.confirm_beyond_m;
  }
  const double window_m = verifier_.WindowOf(std::min(a.path_length_m, b.path_length_m)).linear_m;
  return std::max(options_.confirm_beyond_m, options_.confirm_beyond_windows * window_m);
}

// Whether the same two nodes have been looked at before, and accepted, or rejected by hand.
bool LoopCloser::IsClosed(const ClosureRecord& record) const {
  return IsRejectedByHand(record) ||
         std::any_of(closures_.begin(), closures_.end(), [&](const backend::Edge& closure) {
           return closure.i == record.old_node && closure.j == record.node;
         });
}

void LoopCloser::Accept(std::size_t position) {
  ClosureRecord& record = records_[position];
  record.verdict = Verdict::kAccepted;
  accepted_.push_back(position);
  closures_.push_back({.i = record.old_node,
                       .j = record.node,
                       .i_T_j = record.old_T_node,
                       .information = record.information,
                       // No loss doubts what somebody has seen to.
                       .kind = record.is_by_hand ? backend::EdgeKind::kScanMatch
                                                 : backend::EdgeKind::kLoopClosure});
}

bool LoopCloser::Release(std::size_t position) {
  const auto found = std::find(accepted_.begin(), accepted_.end(), position);
  if (found == accepted_.end() || records_[position].is_by_hand) return false;
  records_[position].verdict = Verdict::kReleased;
  closures_.erase(closures_.begin() + (found - accepted_.begin()));
  accepted_.erase(found);
  return true;
}

}  // namespace gmapping_spa::loop_closure
