// SPDX-License-Identifier: BSD-3-Clause
// The cells of a map as a picture: a pixel a cell, and nothing else.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_MAP_CELLS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_MAP_CELLS_H_

#include <string>

#include "experiments/apps/world_file.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::apps {

// Writes a grey PNG with the pixels of map.pgm, and returns where it lies. Throws
// std::runtime_error with one line when the file cannot be written.
PicturePlace WriteMapCells(const map::TrinaryMap& map, const std::string& png_path);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_MAP_CELLS_H_
