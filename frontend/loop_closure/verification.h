// SPDX-License-Identifier: BSD-3-Clause
// Whether two nodes saw the same place, and how they lie to each other.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_VERIFICATION_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_VERIFICATION_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/loop_closure/candidates.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/loop_closure/drift.h"
#include "frontend/loop_closure/local_map.h"
#include "frontend/loop_closure/rival_search.h"
#include "frontend/scan_matching/correlative_matching.h"
#include "frontend/scan_matching/gauss_newton.h"

namespace gmapping_spa::loop_closure {

// Where a closure is looked for.
struct Expectation {
  backend::SE2 old_T_node;
  scan_matching::SearchWindow window;
};

// Compares what was seen on the way around the one node with a local map made on the way around the
// other: single scans are too easily mistaken.
class Verifier {
 public:
  struct Options {
    double old_reach_m = 8.0;          // of driving to either side, for the local map
    double new_reach_m = 5.0;          // likewise, for the scans that are matched with it
    double cell_m = 0.1;               // at most one end point in each
    double max_turn_rad = 0.4;         // the search goes no farther
    double max_runner_up_score = 0.9;  // part of the best score
    // Of walls and the like in the scans around the node, to move an estimate: two trees fit two
    // others. On recorded logs closures have 30 m and more.
    double min_outline_m = 10.0;
    double max_shift_m = 0.15;  // by which fine alignment may move the peak
    double max_shift_rad = 0.05;
    // At the pose expected, unless the window is large; and at the one found.
    double min_expected_overlap = 0.4;
    double min_overlap = 0.5;
    // Of the scans around the node in the old map; and of the old scans in the new map, where the
    // prior is weak. Less where the scans of either explain each other less.
    double min_inlier_ratio = 0.6;
    double min_mutual_inlier_ratio = 0.6;
    double max_mahalanobis_sq =
        13.8;                        // 99.9 % of a chi-square distribution of 2 degrees of freedom
    double information_gain = 0.02;  // neighboring points share the errors of the maps
    map::OccupancyGrid::Options grid;
    scan_matching::CorrelativeMatcher::Options search;
    scan_matching::GaussNewton::Options gauss_newton;
    friend bool operator==(const Options&, const Options&) = default;
  };

  Verifier(const Options& options, const DriftModel& drift, const CandidateOptions& candidates);

  // Looks where the estimate and its drift say. Of the verdicts up to kUnconfirmed, which is that
  // of what passed. Where drift leaves a large window, the old scans must fit the new map as well.
  ClosureRecord Verify(const std::vector<backend::SE2>& world_T_nodes,
                       const ScanOfNode& scan_of_node, int node, const Candidate& candidate) const;

  // Where Verify looks, around the estimate after such a way.
  scan_matching::SearchWindow WindowOf(double path_length_m) const;

  // Looks in a small window, wherever that is by the estimate: the gate is computed and decides
  // nothing. Stricter, since there may be many places that look alike: the old scans must fit the
  // new map as well.
  ClosureRecord VerifyAt(const std::vector<backend::SE2>& world_T_nodes,
                         const ScanOfNode& scan_of_node, int node, const Candidate& candidate,
                         const Expectation& expectation) const;

 private:
  // All of it but for the gate.
  ClosureRecord Compare(const std::vector<backend::SE2>& world_T_nodes,
                        const ScanOfNode& scan_of_node, int node, const Candidate& candidate,
                        const Expectation& expectation) const;
  // Whether the old scans fit the map of the new ones as well: mutual_inlier_ratio, and its
  // verdict.
  void AskOldScans(const std::vector<backend::SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                   const Expectation& expectation, ClosureRecord* record) const;
  // Whether a closure that has the node elsewhere than the estimate may do so by chance: too little
  // is in sight, or the scans around the node fit the old map about as well where the estimate has
  // them. Then the building repeats itself, and nothing says that the estimate is wrong.
  bool MayBeChance(const std::vector<backend::SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                   const backend::SE2& estimated_old_T_node, const ClosureRecord& record) const;
  // Whether so much is explained as a true closure would have, by how well the scans around the
  // node that is compared explain each other.
  bool Fits(double inlier_ratio, double min_inlier_ratio,
            const std::vector<backend::SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
            int node, NodeRange around) const;
  void LookForRivals(const std::vector<backend::SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                     ClosureRecord* record) const;
  RivalSearch::Options RivalOptions() const;
  scan_matching::CorrelativeMatcher::Options SearchOptions(
      const scan_matching::SearchWindow& window) const;

  Options options_;
  DriftModel drift_;
  CandidateOptions candidates_;
  scan_matching::GaussNewton gauss_newton_;
  RivalSearch rivals_;
};

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_VERIFICATION_H_
