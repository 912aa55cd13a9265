// SPDX-License-Identifier: BSD-3-Clause
// Pieces of map: what a robot that is lost begins, and one of which only its map of before is
// known.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frontend/improved_gmapping.h"

namespace gmapping_spa::frontend {

using backend::SE2;

// The node of the piece is its first scan: what came before belongs to the piece before.
void ImprovedGmapping::BeginPiece(int scans, bool wheels_told_way) {
  scan_poses_.BeginPiece(scans - 1);
  const int first = archive_.size() - scans;
  const SE2 odom_T_first = scan_poses_.OdometryOf(scans - 1);
  filter_.BeginPiece(archive_.Get(first), Between(odom_T_last_update_, odom_T_first));
  loop_closer_.BeginPiece(static_cast<int>(node_scans_.size()), wheels_told_way);
  if (session_) session_->BeginPiece();
  node_scans_.push_back(first);
  std::fill(is_lost_.begin() + first, is_lost_.end(), false);
  is_drawn_.assign(loop_closer_.pieces().size(), false);
  is_drawn_.back() = true;
  filter_.ForgetMapHistory();
  ++counts_.updates;
  ++counts_.pieces;
  ++updates_since_optimization_;
  odom_T_last_update_ = odom_T_first;
  const SE2 since = Between(odom_T_first, odom_T_scan_);
  increments_since_update_.clear();
  if (options_.filter.motion.noise_at_each_scan) increments_since_update_.push_back(since);
  linear_since_update_m_ = since.translation().norm();
  angular_since_update_rad_ = std::abs(since.theta);
}

// Puts pieces to where closures join them that no optimization has put there: they came after the
// last one began, or it failed, or was not waited for.
void ImprovedGmapping::JoinPieces() {
  const loop_closure::Pieces& pieces = loop_closer_.pieces();
  if (pieces.size() == 1) return;
  backend::PoseGraphRecorder recorder;
  EmitGraph(&recorder);
  world_T_nodes_before_ = backend::PosesOf(recorder.graph());
  closures_before_ = loop_closer_.closures();
  backend::PoseGraph graph = recorder.graph();
  pieces.Arrange(closures_before_, &graph);
  if (closure_waits_) {
    if (const auto optimized = graph_thread_.Run(graph)) graph = *optimized;
    closure_waits_ = false;
  }
  ApplyOptimizedGraph(graph);
}

// Nothing is drawn over a map that it is not joined with.
sensor::LaserScan ImprovedGmapping::DrawnScanOfNode(int node) const {
  sensor::LaserScan scan = ScanOfNode(node);
  if (!is_drawn_[loop_closer_.pieces().PieceOf(node)]) scan.beams.clear();
  return scan;
}

// Those that hold the most of the nodes, and what is joined with them: in a session the most of the
// nodes of before, whose map it goes on with.
std::vector<bool> ImprovedGmapping::DrawnInTheEnd() const {
  const int nodes = session_ ? session_->nodes() : static_cast<int>(node_scans_.size());
  return loop_closer_.pieces().Largest(nodes, loop_closer_.closures());
}

std::vector<bool> ImprovedGmapping::DrawnScans(const std::vector<bool>& is_piece_drawn) const {
  std::vector<bool> is_drawn(is_lost_.size());
  std::size_t node = 0;  // the last one up to the scan
  for (std::size_t k = 0; k < is_lost_.size(); ++k) {
    if (node + 1 < node_scans_.size() && node_scans_[node + 1] <= static_cast<int>(k)) ++node;
    const int piece = loop_closer_.pieces().PieceOf(static_cast<int>(node));
    is_drawn[k] = !is_lost_[k] && is_piece_drawn[piece];
  }
  return is_drawn;
}

void ImprovedGmapping::ReportPieces(const std::vector<bool>& is_drawn) {
  const loop_closure::Pieces& pieces = loop_closer_.pieces();
  for (int piece = 0; piece < pieces.size(); ++piece) {
    if (is_drawn[piece]) continue;
    const int first = node_scans_[pieces.FirstNode(piece)];
    const int end =
        piece + 1 < pieces.size() ? node_scans_[pieces.FirstNode(piece + 1)] : archive_.size();
    health_.Report("piece_not_joined", archive_.StampOf(first),
                   "a piece of " + std::to_string(end - first) +
                       " scans was never joined with the map: it is not drawn, and where the robot "
                       "was then is not known");
    for (int k = first; k < end; ++k) {
      if (!is_lost_[k]) health_.Mark("lost", archive_.StampOf(k));  // the others are marked
    }
    health_.MergeStretches("lost");
  }
}

void ImprovedGmapping::BeginSession(MapSession::Use use) {
  const SlamResult known = Finish();
  const std::vector<SE2> world_T_nodes = backend::PosesOf(known.graph);
  // What is known is the same for all particles.
  filter_.KeepOnly(filter_.BestParticle());
  filter_.ForgetMapHistory();
  filter_.CorrectHistories({filter_.PosesOfPath(0), world_T_nodes},
                           [this](int node) { return DrawnScanOfNode(node); });
  const loop_closure::Pieces& pieces = loop_closer_.pieces();
  const std::vector<bool> is_drawn = DrawnInTheEnd();
  std::vector<int> nodes;
  for (int node = 0; node < static_cast<int>(node_scans_.size()); ++node) {
    if (is_drawn[pieces.PieceOf(node)]) nodes.push_back(node);
  }
  std::int64_t first_index = 0;
  for (int k = 0; k < archive_.size(); ++k) {
    first_index = std::max(first_index, archive_.IndexOf(k) + 1);
  }
  MapSession::Known of_before(options_.filter.grid);
  of_before.world_T_nodes = world_T_nodes;
  of_before.nodes = std::move(nodes);
  of_before.map = known.map;
  of_before.trajectory = known.trajectory;
  of_before.first_index = first_index;
  session_.emplace(use, std::move(of_before));
  LeaveSearchToSession();
  archive_.BeginSession();
  health_ = Health();
  control_ = ControlInput(options_.control, &health_);
  counts_ = Counts();
}

// The look of a place finds some that are like it; in the old map the session looks at all there
// are.
void ImprovedGmapping::LeaveSearchToSession() {
  loop_closer_.JoinPiecesFrom(session_->is_fixed() ? std::numeric_limits<int>::max()
                                                   : session_->nodes());
}

bool ImprovedGmapping::IsPlaced() const {
  if (!session_) return true;
  const int old_piece = loop_closer_.pieces().PieceOf(session_->known().nodes.front());
  return !session_->searches() && is_drawn_[old_piece];
}

bool ImprovedGmapping::HasTaken(std::int64_t k, const sensor::LaserScan& scan) const {
  return session_
             ? archive_.Holds(static_cast<int>(session_->scans() + k), session_->Numbered(scan))
             : archive_.Holds(static_cast<int>(k), scan);
}

void ImprovedGmapping::LookForRobot(const sensor::LaserScan& scan, const SE2& motion) {
  const int node = static_cast<int>(node_scans_.size()) - 1;
  const MapSession::Outcome outcome =
      session_->AddScan(scan, motion, node, Between(odom_T_scan_, odom_T_last_update_));
  if (outcome.closure) {
    loop_closer_.Add(*outcome.closure);
  } else if (outcome.taken_back) {
    loop_closer_.TakeBackLocalization();
    health_.Report("localization_taken_back", scan.stamp_s,
                   "what is seen contradicts the map where the robot was found in it: it is looked "
                   "for anew");
  } else {
    return;
  }
  closure_waits_ = true;
}

}  // namespace gmapping_spa::frontend
