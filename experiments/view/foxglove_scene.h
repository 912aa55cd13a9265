// SPDX-License-Identifier: BSD-3-Clause
// The pose graph as a foxglove.SceneUpdate.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_SCENE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_SCENE_H_

#include <nlohmann/json.hpp>

#include "experiments/view/run_state.h"

namespace gmapping_spa::view {

// Three entities, each a list of lines: path, accepted closures, refused ones.
nlohmann::json FoxgloveScene(const RunState& run);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_SCENE_H_
