// SPDX-License-Identifier: BSD-3-Clause
// The map as a foxglove.Grid.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_MAP_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_MAP_H_

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "experiments/view/run_state.h"

namespace gmapping_spa::view {

// A field "occupancy" of a byte a cell, as in TileImage; the whole rectangle of known tiles.
nlohmann::json FoxgloveMap(const RunState& run);

// As RFC 4648 has it.
std::string Base64(std::string_view bytes);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_MAP_H_
