// SPDX-License-Identifier: BSD-3-Clause
// A run as topics of Foxglove: messages of its well-known schemas, as JSON.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_TOPICS_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_TOPICS_H_

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/view/run_state.h"

namespace gmapping_spa::view {

struct FoxgloveTopic {
  const char* name;                    // "/map"
  const char* schema_name;             // "foxglove.Grid"
  const char* schema;                  // JSON schema of what is used of it
  int RunState::Revisions::*revision;  // which says whether there is something new
  double least_period_s;               // between two messages
  nlohmann::json (*message)(const RunState& run);
};

// Frames: map, base_link, laser. A channel's id is its position.
const std::vector<FoxgloveTopic>& FoxgloveTopics();

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_TOPICS_H_
