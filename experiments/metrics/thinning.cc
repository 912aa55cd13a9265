// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/thinning.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

// Around a cell from the top clockwise: P2 to P9 of the paper.
constexpr std::array<std::array<int, 2>, 8> kAround = {
    {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

bool MayGo(const TrinaryMap& map, int column, int row, bool first_half) {
  std::array<bool, 8> p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p[i] = StateAt(map, column + kAround[i][0], row + kAround[i][1]) == CellState::kOccupied;
  }
  int begins = 0;  // of runs of occupied neighbors
  for (std::size_t i = 0; i < p.size(); ++i) begins += !p[i] && p[(i + 1) % p.size()];
  const auto neighbors = std::count(p.begin(), p.end(), true);
  if (neighbors < 2 || neighbors > 6 || begins != 1) return false;
  const auto [top, right, bottom, left] = std::array{p[0], p[2], p[4], p[6]};
  return first_half ? !(top && right && bottom) && !(right && bottom && left)
                    : !(top && right && left) && !(top && bottom && left);
}

}  // namespace

TrinaryMap Thinned(TrinaryMap map) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const bool first_half : {true, false}) {
      std::vector<std::array<int, 2>> gone;
      for (int row = 0; row < map.height; ++row) {
        for (int column = 0; column < map.width; ++column) {
          if (map.at(column, row) == CellState::kOccupied && MayGo(map, column, row, first_half)) {
            gone.push_back({column, row});
          }
        }
      }
      for (const auto& [column, row] : gone) map.at(column, row) = CellState::kFree;
      changed = changed || !gone.empty();
    }
  }
  return map;
}

}  // namespace gmapping_spa::metrics
