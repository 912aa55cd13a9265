// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/truth_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gmapping_spa::simulation {
namespace {

using map::CellState;
using map::TrinaryMap;

// Marks what is reachable and what can be seen from there, at the world's resolution.
TrinaryMap Explore(const TrinaryMap& world, int start_column, int start_row) {
  TrinaryMap seen = world;
  std::fill(seen.cells.begin(), seen.cells.end(), CellState::kUnknown);
  std::vector<std::pair<int, int>> frontier = {{start_column, start_row}};
  seen.at(start_column, start_row) = CellState::kFree;
  while (!frontier.empty()) {
    const auto [column, row] = frontier.back();
    frontier.pop_back();
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, world.height - 1); ++y) {
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, world.width - 1); ++x) {
        if (seen.at(x, y) != CellState::kUnknown) continue;
        if (world.at(x, y) == CellState::kOccupied) {
          seen.at(x, y) = CellState::kOccupied;
        } else if (x == column || y == row) {
          seen.at(x, y) = CellState::kFree;
          frontier.emplace_back(x, y);
        }
      }
    }
  }
  return seen;
}

}  // namespace

TrinaryMap TruthMap(const World& world, const Eigen::Vector2d& world_start, double resolution_m) {
  const TrinaryMap& raster = world.raster();
  const double ratio = resolution_m / raster.resolution_m;
  const int factor = static_cast<int>(std::lround(std::clamp(ratio, 0.0, 1e6)));
  if (factor < 1 || std::abs(ratio - factor) > 1e-6 * factor) {
    throw std::runtime_error("truth map: expected a multiple of the world's resolution of " +
                             std::to_string(raster.resolution_m) + " m, found " +
                             std::to_string(resolution_m) + " m");
  }
  const Eigen::Vector2d start =
      (world_start - Eigen::Vector2d(raster.origin_x_m, raster.origin_y_m)) / raster.resolution_m;
  const bool inside =
      start.x() >= 0.0 && start.x() < raster.width && start.y() >= 0.0 && start.y() < raster.height;
  if (!inside ||
      raster.at(static_cast<int>(start.x()), static_cast<int>(start.y())) == CellState::kOccupied) {
    throw std::runtime_error(
        "truth map: expected the tour to start in an empty cell of the world with its obstacles, "
        "found (" +
        std::to_string(world_start.x()) + ", " + std::to_string(world_start.y()) + ")");
  }
  const TrinaryMap fine = Explore(raster, static_cast<int>(start.x()), static_cast<int>(start.y()));

  TrinaryMap coarse = fine;
  coarse.resolution_m = resolution_m;
  coarse.width = (fine.width + factor - 1) / factor;
  coarse.height = (fine.height + factor - 1) / factor;
  coarse.cells.assign(static_cast<std::size_t>(coarse.width) * coarse.height, CellState::kUnknown);
  for (int row = 0; row < fine.height; ++row) {
    for (int column = 0; column < fine.width; ++column) {
      CellState& state = coarse.at(column / factor, row / factor);
      state = std::max(state, fine.at(column, row));  // unknown < free < occupied
    }
  }
  return coarse;
}

TrinaryMap Added(const TrinaryMap& truth, const TrinaryMap& truth_of_empty_world) {
  if (truth.width != truth_of_empty_world.width || truth.height != truth_of_empty_world.height) {
    throw std::invalid_argument("true maps of one world: expected the same grid");
  }
  TrinaryMap added = truth;
  for (std::size_t i = 0; i < added.cells.size(); ++i) {
    if (truth_of_empty_world.cells[i] == CellState::kOccupied) {
      added.cells[i] = CellState::kUnknown;
    }
  }
  return added;
}

}  // namespace gmapping_spa::simulation
