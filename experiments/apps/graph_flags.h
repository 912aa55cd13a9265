// SPDX-License-Identifier: BSD-3-Clause
// Flags of the pose graph: its edges, loop closures, graph thread, correction, final optimization.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_FLAGS_H_

#include "experiments/apps/flag_groups.h"
#include "frontend/api/slam_options.h"

namespace gmapping_spa::apps {

FlagGroups GraphFlagGroups();

// Sets what the flags say. Throws std::runtime_error with one line when a flag makes no sense.
void AddGraphOptions(SlamOptions* options);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_FLAGS_H_
