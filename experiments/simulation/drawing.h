// SPDX-License-Identifier: BSD-3-Clause
// Shapes drawn over a raster.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_DRAWING_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_DRAWING_H_

#include "experiments/simulation/shapes.h"
#include "frontend/map/trinary_map.h"
#include "frontend/map/yaml_file.h"

namespace gmapping_spa::simulation {

// Makes the cells solid whose centres lie in the shape; returns whether there are any.
bool Draw(const Rectangle& rectangle, map::TrinaryMap* raster);
bool Draw(const Disc& disc, map::TrinaryMap* raster);

// Draws what a world file or a file of obstacles lists, in metres:
//   boxes: [x_min, y_min, x_max, y_max]
//   walls: [x1, y1, x2, y2, thickness], from end to end, with square ends
//   discs: [x, y, radius]
// Throws std::runtime_error "<path>[:<line>]: <what was expected, what was found>"; a shape that
// covers no cell is an error.
void DrawShapes(const map::YamlFile& yaml, map::TrinaryMap* raster);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_DRAWING_H_
