// SPDX-License-Identifier: BSD-3-Clause
// Where a loop may have closed.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CANDIDATES_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CANDIDATES_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/loop_closure/drift.h"

namespace gmapping_spa::loop_closure {

struct CandidateOptions {
  double min_path_length_m = 15.0;  // between two nodes: nearer ones know enough of each other
  double max_distance_m = 4.0;      // at which two scans still see the same
  double sigmas = 3.0;        // of the drift by which nodes may be farther apart than estimated
  double max_drift_m = 10.0;  // the search goes no farther
  int max_candidates = 3;     // that belong to different passes
  friend bool operator==(const CandidateOptions&, const CandidateOptions&) = default;
};

struct Candidate {
  int old_node = 0;
  double path_length_m = 0.0;  // shortest in the graph
  double distance_m = 0.0;     // by the present estimate
};

// Older nodes that `node` may be near, the nearest of each pass, most likely one first.
// `path_lengths_m[k]` is the shortest way to node k. A full search: the ways themselves, which tell
// how far to look, take longer than a look at every node.
std::vector<Candidate> FindCandidates(const CandidateOptions& options, const DriftModel& drift,
                                      const std::vector<backend::SE2>& world_T_nodes,
                                      const std::vector<double>& ways_driven_m,
                                      const std::vector<double>& path_lengths_m, int node);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_CANDIDATES_H_
