// SPDX-License-Identifier: BSD-3-Clause
// Closures that are left undecided in the end, though they would move the map.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_UNPROVEN_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_UNPROVEN_H_

#include <span>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/loop_closure/closure_set.h"
#include "frontend/loop_closure/drift.h"

namespace gmapping_spa::loop_closure {

struct UnprovenClosure {
  int node = 0;
  double moved_m = 0.0;  // by which it would move the node
};

struct UnprovenOptions {
  // Of driving, from another one that agrees: nearer ones see the same scans.
  double apart_m = 1.5;
  double within_m = 20.0;
  double settled_m = 10.0;  // of driving, within which an accepted closure has decided
  ProofOptions proof;
};

// Of `records` those that fit, unconfirmed or for a rival not believed, which another one agrees
// with, which drift explains and which would move a node where no loop was closed; those that would
// move it farthest first. A map without such a closure may be right or bent: its user has to know.
std::vector<UnprovenClosure> UnprovenClosures(const UnprovenOptions& options,
                                              const DriftModel& drift, const DrivenPath& path,
                                              std::span<const backend::Edge> closures,
                                              const std::vector<ClosureRecord>& records);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_UNPROVEN_H_
