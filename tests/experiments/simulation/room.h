// SPDX-License-Identifier: BSD-3-Clause
// A room to measure in.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_SIMULATION_ROOM_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_SIMULATION_ROOM_H_

#include <vector>

#include "experiments/simulation/world.h"

namespace gmapping_spa::simulation {

// A room of 8 m x 6 m with walls one cell (0.1 m) thick.
inline World Room() {
  using map::CellState;
  map::TrinaryMap raster{80, 60, 0.1, 0.0, 0.0, std::vector<CellState>(4800, CellState::kFree)};
  for (int column = 0; column < 80; ++column) {
    raster.at(column, 0) = raster.at(column, 59) = CellState::kOccupied;
  }
  for (int row = 0; row < 60; ++row) raster.at(0, row) = raster.at(79, row) = CellState::kOccupied;
  return World(raster);
}

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_SIMULATION_ROOM_H_
