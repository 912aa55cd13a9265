// SPDX-License-Identifier: BSD-3-Clause
// Closes loops wherever they are: by the look of places, and by what follows from that.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_GLOBAL_CLOSING_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_GLOBAL_CLOSING_H_

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/loop_closure/closure_set.h"
#include "frontend/loop_closure/place_search.h"
#include "frontend/loop_closure/verification.h"

namespace gmapping_spa::loop_closure {

// Takes places for others only where drift may have made the estimate useless; a single one proves
// nothing. It is followed along the path to both sides: at each step what the hypothesis predicts
// is verified, or contradicted. A set of closures is believed when it is proven, see ClosureSet,
// and given up again when it meets too many contradictions later.
class GlobalCloser {
 public:
  struct Options {
    double place_every_m = 3.0;       // of driving
    double search_every_m = 6.0;      // likewise, on the way; in the end each place is looked for
    double min_path_length_m = 60.0;  // in the graph: nearer nodes are found by the estimate
    // A node that was driven so near to an accepted closure is not lost.
    double settled_m = 10.0;
    double max_runner_up_score = 0.9;  // of a match of places, as of closures
    double follow_every_m = 2.0;       // of driving
    double follow_up_to_m = 12.0;      // of driving, beyond the last member
    double seed_window_m = 0.5;        // around the match of places
    double seed_window_rad = 0.1;
    double wheels_window_m = 3.0;  // around where the wheels say, from piece to piece
    double wheels_window_rad = 0.4;
    double window_m_per_m = 0.05;  // grows with the driving from the nearest member
    double window_rad_per_m = 0.01;
    double old_window_m = 20.0;  // of driving, around the nearest member's old node
    PlaceSearch::Options search;
    ProofOptions proof;
    friend bool operator==(const Options&, const Options&) = default;
  };

  // From now on places that no path in the graph leads to are taken for others from this node on
  // only.
  void JoinPiecesFrom(int node) { joinable_from_ = node; }

  // What is to be believed from now on, and what no longer: positions in the records.
  struct Decisions {
    std::vector<std::size_t> accept;
    std::vector<std::size_t> release;
    std::vector<std::size_t> restore;  // accept, although released before
  };

  GlobalCloser(const Options& options, const Verifier& verifier, const DriftModel& drift,
               const CandidateOptions& candidates);

  // Looks for the places that the path has left behind, and follows hypotheses up to there. Adds
  // records of what it looked at. `by_wheels`: poses of the nodes of which those of two pieces that
  // are not joined are near each other only where the wheels say so.
  Decisions Update(const DrivenPath& path, const std::vector<backend::SE2>& by_wheels,
                   const ScanOfNode& scan_of_node, std::span<const backend::Edge> closures,
                   std::vector<ClosureRecord>* records);

  // Looks for all places that no accepted closure is near to and that were not looked for.
  Decisions Finish(const DrivenPath& path, const std::vector<backend::SE2>& by_wheels,
                   const ScanOfNode& scan_of_node, std::span<const backend::Edge> closures,
                   std::vector<ClosureRecord>* records);

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(places_, searched_, last_search_m_, sets_);
  }

 private:
  // What all steps of a call share.
  struct Call {
    const DrivenPath& path;
    const std::vector<backend::SE2>& by_wheels;
    const ScanOfNode& scan_of_node;
    std::span<const backend::Edge> closures;
    std::vector<ClosureRecord>* records;
    int last_node;  // the last one that is far enough behind to be verified
  };

  void AddPlaces(const Call& call);
  void Search(const Call& call, int place);
  bool IsSettled(const Call& call, int node) const;
  void SearchNearWheels(const Call& call, int node, const std::vector<double>& ways);
  void AddSeed(const Call& call, const ClosureRecord& record);
  bool WheelsAgree(const Call& call, const ClosureRecord& record) const;
  bool IsExplained(const Call& call, int node, int old_node, const backend::SE2& old_T_node) const;
  void FollowAll(const Call& call);
  void Follow(const Call& call, int direction, ClosureSet* set);
  void Look(const Call& call, int node, ClosureSet* set);
  std::optional<Candidate> Predict(const Call& call, const ClosureRecord& member, int node) const;
  Decisions Decide(const Call& call);

  Options options_;
  Verifier verifier_;
  DriftModel drift_;
  CandidateOptions candidates_;
  PlaceSearch places_;
  int joinable_from_ = 0;
  std::vector<bool> searched_;  // of each place
  double last_search_m_ = 0.0;
  std::vector<ClosureSet> sets_;
};

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_GLOBAL_CLOSING_H_
