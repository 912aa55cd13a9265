// SPDX-License-Identifier: BSD-3-Clause
// Whether a closure may have mistaken one part of a building that repeats itself for another.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_RIVAL_SEARCH_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_RIVAL_SEARCH_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/loop_closure/local_map.h"
#include "frontend/scan_matching/correlative_matching.h"

namespace gmapping_spa::loop_closure {

// Where a building repeats itself, a closure is right only if it leads to the nearest one of the
// places that look alike: if the estimate is off by less than half of what they are apart, or by a
// quarter, as there may be another one between them that was not seen yet. So whoever moves the
// estimate must find no second place within four times that way of the first.
class RivalSearch {
 public:
  struct Options {
    double old_reach_m = 8.0;   // of driving to either side, for the places looked at
    double new_reach_m = 5.0;   // likewise, for the scans that are matched with them
    double cell_m = 0.1;        // at most one end point in each
    double min_way_m = 15.0;    // of driving, from the node: what is nearer belongs to its own pass
    double elsewhere_m = 0.5;   // nearer poses are the same place
    double max_reach_m = 10.0;  // the search goes no farther
    double max_turn_rad = 0.1;  // parts of a building that repeat lie in parallel
    double max_runner_up_score = 0.9;  // part of the closure's score from which on it is a rival
    scan_matching::CorrelativeMatcher::Options search;
    friend bool operator==(const Options&, const Options&) = default;
  };

  explicit RivalSearch(const Options& options) : options_(options) {}

  // `record`: what was found between two nodes of the path, elsewhere than their poses say.
  bool HasRival(const std::vector<backend::SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                const ClosureRecord& record) const;

 private:
  std::vector<int> PlacesAround(const std::vector<backend::SE2>& world_T_nodes, int node,
                                const backend::SE2& world_T_found, double reach_m) const;

  Options options_;
};

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_RIVAL_SEARCH_H_
