// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/object_errors.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "experiments/metrics/connected_cells.h"
#include "experiments/metrics/statistics.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

void CheckThatTheyStandIn(const TrinaryMap& truth, const TrinaryMap& objects) {
  const double play_m = 1e-6 * truth.resolution_m;
  if (objects.width != truth.width || objects.height != truth.height ||
      std::abs(objects.resolution_m - truth.resolution_m) > play_m ||
      std::abs(objects.origin_x_m - truth.origin_x_m) > play_m ||
      std::abs(objects.origin_y_m - truth.origin_y_m) > play_m) {
    throw std::runtime_error("expected objects in the grid of the true map, found another grid");
  }
  for (std::size_t i = 0; i < objects.cells.size(); ++i) {
    if (objects.cells[i] != CellState::kOccupied || truth.cells[i] == CellState::kOccupied)
      continue;
    throw std::runtime_error(
        "expected objects that stand in the true map, found an occupied cell that is not so there");
  }
}

}  // namespace

std::vector<ObjectErrors> FindObjectErrors(const TrinaryMap& truth, const TrinaryMap& objects,
                                           const MapComparison& comparison, double tolerance_m) {
  CheckThatTheyStandIn(truth, objects);
  std::vector<ObjectErrors> errors;
  for (const auto& cells : ConnectedCells(objects)) {
    Eigen::Vector2d low = CellCenter(truth, cells[0][0], cells[0][1]), high = low;
    std::vector<bool> is_of_it(objects.cells.size(), false);
    for (const auto& [column, row] : cells) {
      const Eigen::Vector2d center = CellCenter(truth, column, row);
      low = low.cwiseMin(center);
      high = high.cwiseMax(center);
      is_of_it[static_cast<std::size_t>(row) * truth.width + column] = true;
    }
    int in_sight = 0, drawn = 0;
    std::vector<double> widths_m;
    for (std::size_t i = 0; i < comparison.surface.size(); ++i) {
      const SurfaceElement& element = comparison.surface[i];
      if (!is_of_it[static_cast<std::size_t>(element.row) * truth.width + element.column]) continue;
      const ComparedElement& compared = comparison.elements[i];
      ++in_sight;
      if (!IsWithin(compared.distance_m, tolerance_m)) continue;
      ++drawn;
      if (!compared.bands.empty()) widths_m.push_back(compared.bands.front().width_m());
    }
    ObjectErrors& object = errors.emplace_back();
    object.center = 0.5 * (low + high);
    object.surface_m = in_sight * truth.resolution_m;
    if (in_sight > 0) object.complete = static_cast<double>(drawn) / in_sight;
    if (const auto width = ComputeMeanAndP95(std::move(widths_m))) object.width_m = width->mean;
  }
  return errors;
}

}  // namespace gmapping_spa::metrics
