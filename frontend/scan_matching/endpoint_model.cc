#include "frontend/scan_matching/endpoint_model.h"

#include <glog/logging.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace gmapping_spa::scan_matching {
namespace {

// Calls visit(d^2), in square cells, for every beam that the map explains.
template <typename Visit>
void ForEachExplainedBeam(const map::OccupancyGrid& grid, const ScanPoints& points,
                          const backend::SE2& world_T_robot, const Visit& visit) {
  using map::CellIndex;
  using map::FloorToCell;
  const double cells_per_m = 1.0 / grid.resolution_m();
  const double c = std::cos(world_T_robot.theta), s = std::sin(world_T_robot.theta);
  const double cx = c * cells_per_m, sx = s * cells_per_m;
  const double x0 = world_T_robot.x * cells_per_m, y0 = world_T_robot.y * cells_per_m;
  for (const ScanPoint& point : points) {
    const double x = x0 + cx * point.x_m - sx * point.y_m;
    const double y = y0 + sx * point.x_m + cx * point.y_m;
    const CellIndex end{FloorToCell(x), FloorToCell(y)};
    unsigned full = grid.FullNeighbourhood(end);
    if (full == 0) continue;
    // The cell in front: one cell diagonal back along the beam.
    const double back_x = c * point.back_x - s * point.back_y;
    const double back_y = s * point.back_x + c * point.back_y;
    const int front_dx = FloorToCell(x + std::numbers::sqrt2 * back_x) - end.x;
    const int front_dy = FloorToCell(y + std::numbers::sqrt2 * back_y) - end.y;
    double nearest = std::numeric_limits<double>::infinity();
    for (; full != 0; full &= full - 1) {
      const int k = std::countr_zero(full);
      const CellIndex at{end.x + k % 3 - 1, end.y + k / 3 - 1};
      if (grid.IsFull({at.x + front_dx, at.y + front_dy})) continue;
      const map::Cell& cell = grid.cell(at);
      constexpr double kPerUnit = 1.0 / map::Cell::kMeanScale;
      const double dx = x - at.x - cell.mean_x * kPerUnit;
      const double dy = y - at.y - cell.mean_y * kPerUnit;
      nearest = std::min(nearest, dx * dx + dy * dy);
    }
    if (std::isfinite(nearest)) visit(nearest);
  }
}

}  // namespace

EndpointModel::EndpointModel(const Options& options) : options_(options) {
  CHECK_GT(options.score_sigma_m, 0.0);
  CHECK_GT(options.likelihood_sigma_m, 0.0);
  CHECK_GT(options.unmatched_distance_m, 0.0);
}

double EndpointModel::Score(const map::OccupancyGrid& grid, const ScanPoints& points,
                            const backend::SE2& world_T_robot) const {
  if (points.empty()) return 0.0;
  const double scale = -0.5 * std::pow(grid.resolution_m() / options_.score_sigma_m, 2);
  double sum = 0.0;
  ForEachExplainedBeam(grid, points, world_T_robot, [&](double squared_cells) {
    sum += std::exp(static_cast<float>(scale * squared_cells));
  });
  return sum / static_cast<double>(points.size());
}

double EndpointModel::LogLikelihood(const map::OccupancyGrid& grid, const ScanPoints& points,
                                    const backend::SE2& world_T_robot) const {
  const double limit = std::pow(options_.unmatched_distance_m / grid.resolution_m(), 2);
  double sum = limit * static_cast<double>(points.size());
  ForEachExplainedBeam(grid, points, world_T_robot, [&](double squared_cells) {
    sum += std::min(squared_cells, limit) - limit;
  });
  return -0.5 * std::pow(grid.resolution_m() / options_.likelihood_sigma_m, 2) * sum;
}

}  // namespace gmapping_spa::scan_matching
