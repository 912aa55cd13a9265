#include "experiments/metrics/map_structure.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

bool IsOccupied(const TrinaryMap& map, int column, int row) {
  return StateAt(map, column, row) == CellState::kOccupied;
}

// Whether any of the 3 x 3 cells around this one is as asked for.
template <typename Test>
bool AnyAround(int column, int row, const Test& test) {
  for (int y = row - 1; y <= row + 1; ++y) {
    for (int x = column - 1; x <= column + 1; ++x) {
      if (test(x, y)) return true;
    }
  }
  return false;
}

// With a frame of unknown cells: maps end at their outermost walls, which have corners too.
TrinaryMap Framed(const TrinaryMap& map) {
  constexpr int kFrame = 3;  // reach of the sums of derivatives
  TrinaryMap framed = map;
  framed.width += 2 * kFrame;
  framed.height += 2 * kFrame;
  framed.cells.assign(static_cast<std::size_t>(framed.width) * framed.height, CellState::kUnknown);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      framed.at(column + kFrame, row + kFrame) = map.at(column, row);
    }
  }
  return framed;
}

// Morphological closing of the occupied cells: dilation, then erosion.
TrinaryMap Closed(const TrinaryMap& map) {
  TrinaryMap dilated = map, closed = map;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (AnyAround(column, row, [&](int x, int y) { return IsOccupied(map, x, y); })) {
        dilated.at(column, row) = CellState::kOccupied;
      }
    }
  }
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (!AnyAround(column, row, [&](int x, int y) { return !IsOccupied(dilated, x, y); })) {
        closed.at(column, row) = CellState::kOccupied;
      }
    }
  }
  return closed;
}

int CountEnclosedAreas(const TrinaryMap& map) {
  std::vector<bool> visited(map.cells.size(), false);
  std::vector<std::pair<int, int>> frontier;
  const auto visit = [&](int column, int row) {
    const std::size_t cell = static_cast<std::size_t>(row) * map.width + column;
    if (visited[cell]) return;
    visited[cell] = true;
    frontier.emplace_back(column, row);
  };
  int areas = 0;
  for (int start_row = 0; start_row < map.height; ++start_row) {
    for (int start_column = 0; start_column < map.width; ++start_column) {
      const bool is_free = map.at(start_column, start_row) == CellState::kFree;
      if (!is_free || visited[static_cast<std::size_t>(start_row) * map.width + start_column]) {
        continue;
      }
      bool enclosed = true;
      visit(start_column, start_row);
      while (!frontier.empty()) {
        const auto [column, row] = frontier.back();
        frontier.pop_back();
        for (const auto& [x, y] : {std::pair(column + 1, row), std::pair(column - 1, row),
                                   std::pair(column, row + 1), std::pair(column, row - 1)}) {
          const CellState state = StateAt(map, x, y);
          if (state == CellState::kUnknown) enclosed = false;
          if (state == CellState::kFree) visit(x, y);
        }
      }
      areas += enclosed;
    }
  }
  return areas;
}

// Harris' measure of every cell, from the image that is 1 where the map is occupied.
std::vector<double> CornerStrength(const TrinaryMap& map) {
  struct Products {
    double xx = 0.0, xy = 0.0, yy = 0.0;
  };
  std::vector<Products> products(map.cells.size());
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const auto at = [&](int x, int y) {
        return IsOccupied(map, column + x, row + y) ? 1.0 : 0.0;
      };
      const double dx =
          at(1, -1) + 2 * at(1, 0) + at(1, 1) - at(-1, -1) - 2 * at(-1, 0) - at(-1, 1);
      const double dy =
          at(-1, 1) + 2 * at(0, 1) + at(1, 1) - at(-1, -1) - 2 * at(0, -1) - at(1, -1);
      products[static_cast<std::size_t>(row) * map.width + column] = {dx * dx, dx * dy, dy * dy};
    }
  }
  std::vector<double> strength(map.cells.size(), 0.0);
  for (int row = 2; row + 2 < map.height; ++row) {
    for (int column = 2; column + 2 < map.width; ++column) {
      Products sum;
      for (int y = row - 2; y <= row + 2; ++y) {
        for (int x = column - 2; x <= column + 2; ++x) {
          const Products& p = products[static_cast<std::size_t>(y) * map.width + x];
          sum.xx += p.xx, sum.xy += p.xy, sum.yy += p.yy;
        }
      }
      const double trace = sum.xx + sum.yy;
      strength[static_cast<std::size_t>(row) * map.width + column] =
          sum.xx * sum.yy - sum.xy * sum.xy - 0.04 * trace * trace;
    }
  }
  return strength;
}

int CountCorners(const TrinaryMap& map) {
  constexpr double kMinStrength = 0.5 * 11047.0;  // the corner of a wide wall has 11047
  constexpr int kRadius = 3;
  const std::vector<double> strength = CornerStrength(map);
  int corners = 0;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * map.width + column;
      bool is_corner = strength[cell] > kMinStrength;
      for (int y = std::max(row - kRadius, 0);
           is_corner && y <= std::min(row + kRadius, map.height - 1); ++y) {
        for (int x = std::max(column - kRadius, 0); x <= std::min(column + kRadius, map.width - 1);
             ++x) {
          const std::size_t other = static_cast<std::size_t>(y) * map.width + x;
          // Of equal ones the first counts.
          if (strength[other] > strength[cell] ||
              (strength[other] == strength[cell] && other < cell)) {
            is_corner = false;
          }
        }
      }
      corners += is_corner;
    }
  }
  return corners;
}

}  // namespace

MapStructure MeasureStructure(const TrinaryMap& map) {
  const TrinaryMap closed = Closed(Framed(map));
  return {.occupied_cells = static_cast<int>(
              std::count(map.cells.begin(), map.cells.end(), CellState::kOccupied)),
          .enclosed_areas = CountEnclosedAreas(closed),
          .corners = CountCorners(closed)};
}

}  // namespace gmapping_spa::metrics
