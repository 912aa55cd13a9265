// SPDX-License-Identifier: BSD-3-Clause
// Closes loops: finds candidates, verifies them and believes those that agree with each other.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_LOOP_CLOSER_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_LOOP_CLOSER_H_

#include <vector>

#include "backend/graph/pose_graph.h"
#include "frontend/loop_closure/candidates.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/loop_closure/drift.h"
#include "frontend/loop_closure/global_closing.h"
#include "frontend/loop_closure/local_map.h"
#include "frontend/loop_closure/pieces.h"
#include "frontend/loop_closure/unproven.h"
#include "frontend/loop_closure/verification.h"

namespace gmapping_spa::loop_closure {

class LoopCloser {
 public:
  struct Options {
    double search_every_m = 2.0;  // of driving
    // Two closures confirm each other when the loop through both closes as well as the drift on the
    // way lets expect, within so many standard deviations, and they are no farther apart.
    double confirm_sigmas = 1.0;
    double confirm_within_m = 20.0;
    double confirm_beyond_m = 1.5;  // nearer ones see the same scans
    // Nor do two confirm each other, of which none is accepted, that are nearer than this part of
    // the window that they were found in reaches: they may have mistaken the same obstacle.
    double confirm_beyond_windows = 0.5;
    DriftModel drift;
    CandidateOptions candidates;
    Verifier::Options verifier;
    // Looking for closures farther off than the drift's window, at any heading.
    bool search_everywhere = true;
    GlobalCloser::Options global;
    // Squared error, in variances, from which on an accepted closure contradicts the rest of the
    // graph.
    double max_squared_error = 100.0;
    friend bool operator==(const Options&, const Options&) = default;
  };

  explicit LoopCloser(const Options& options);

  // No scan tells the motion to this node, later than all before, from the one before it: only
  // places can join what comes now with what was, by their look or, if the wheels told the way, by
  // where that leads.
  void BeginPiece(int node, bool wheels_told_way) { pieces_.Begin(node, wheels_told_way); }
  const Pieces& pieces() const { return pieces_; }

  // Pieces are joined by the look of places from this node on only, however alike those before it
  // look: who knows better adds a closure. Not part of sessions.
  void JoinPiecesFrom(int node) { global_.JoinPiecesFrom(node); }

  // `estimate`: world_T_node of all nodes.
  //
  // Looks for closures of the node that the path has left behind by the reach of the verifier's
  // scans: at most one node a call. Returns the number of closures that are newly
  // accepted or released.
  int Update(const std::vector<backend::SE2>& estimate, const ScanOfNode& scan_of_node);

  // Looks for closures of all nodes, with what is known by now.
  int UpdateAll(const std::vector<backend::SE2>& estimate, const ScanOfNode& scan_of_node);

  // Accepts a closure that was found elsewhere.
  void Add(const ClosureRecord& record) {
    records_.push_back(record);
    Accept(records_.size() - 1);
  }

  // Rejects the latest closure of a robot that was found in the map of before, and those that
  // joined its piece with others since.
  void TakeBackLocalization();

  // Releases those accepted closures that an optimized graph with all of them contradicts most, and
  // accepts those released that it agrees with. Returns the number of both: optimize anew, unless
  // zero. `world_T_nodes`: as optimized with closures().
  int Review(const std::vector<backend::SE2>& world_T_nodes);

  // Takes over what somebody made of records(): a record stands for the one of the same nodes and
  // source, in order; those that are left over are new. An accepted one without its own is rejected
  // by hand. What is decided by hand stays as it is: an accepted closure is an edge that no loss
  // weighs and Review does not release; near a rejected one none is accepted again.
  // Returns the number of accepted ones that had none.
  int Edit(const std::vector<ClosureRecord>& edited);

  // How two nodes lie to each other, by their scans: in the window of the drift, or else in the
  // largest one. Verdict kUnconfirmed where they fit, or kRival where they fit elsewhere, too.
  // `estimate`: world_T_node of all nodes.
  ClosureRecord Measure(const std::vector<backend::SE2>& estimate, const ScanOfNode& scan_of_node,
                        int old_node, int node) const;

  // The accepted ones, as edges of the graph.
  const std::vector<backend::Edge>& closures() const { return closures_; }

  // What is left undecided, by the poses of the result; see UnprovenClosures.
  std::vector<UnprovenClosure> Unproven(const std::vector<backend::SE2>& estimate) const;

  // Of every candidate that was looked at.
  const std::vector<ClosureRecord>& records() const { return records_; }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(global_, pieces_, accepted_, closures_, records_, last_search_m_);
  }

 private:
  int SearchNear(const std::vector<backend::SE2>& world_T_nodes,
                 const std::vector<double>& ways_driven, const ScanOfNode& scan_of_node, int node);
  int Confirm(const std::vector<backend::SE2>& world_T_nodes,
              const std::vector<double>& ways_driven, std::size_t newest);
  std::vector<double> WaysAcrossPieces(const std::vector<backend::SE2>& world_T_nodes) const;
  std::vector<backend::SE2> InSight(const std::vector<backend::SE2>& world_T_nodes,
                                    Pieces::Sight sight = Pieces::Sight::kScans) const;
  int Follow(const GlobalCloser::Decisions& decisions);
  double ConfirmBeyond(const ClosureRecord& a, const ClosureRecord& b) const;
  bool IsClosed(const ClosureRecord& record) const;
  bool IsRejectedByHand(const ClosureRecord& record) const;
  void Accept(std::size_t position);
  bool Release(std::size_t position);

  Options options_;
  Verifier verifier_;
  GlobalCloser global_;
  Pieces pieces_;
  std::vector<std::size_t> accepted_;  // positions in records_ of closures_
  std::vector<backend::Edge> closures_;
  std::vector<ClosureRecord> records_;
  double last_search_m_ = 0.0;
};

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_LOOP_CLOSER_H_
