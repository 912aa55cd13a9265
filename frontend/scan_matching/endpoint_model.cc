#include "frontend/scan_matching/endpoint_model.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gmapping_spa::scan_matching {

using map::CellIndex;
using map::FloorToCell;

namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

// The component of a unit vector, rounded to the grid's eight directions.
int Sign(double component) { return (component > 0.5) - (component < -0.5); }

}  // namespace

EndpointModel::EndpointModel(const Options& options, const map::OccupancyGrid* grid,
                             const ScanPoints* points)
    : grid_(grid), points_(points), blocks_(points->size()) {
  CHECK_GT(options.score_sigma_m, 0.0);
  CHECK_GT(options.likelihood_sigma_m, 0.0);
  CHECK_GT(options.unmatched_distance_m, 0.0);
  const double resolution_m = grid->resolution_m();
  score_scale_ = -0.5 * std::pow(resolution_m / options.score_sigma_m, 2);
  likelihood_scale_ = -0.5 * std::pow(resolution_m / options.likelihood_sigma_m, 2);
  unmatched_squared_cells_ = std::pow(options.unmatched_distance_m / resolution_m, 2);
}

double EndpointModel::Score(const backend::SE2& world_T_robot, double at_least) {
  if (points_->empty()) return 0.0;
  const double count = static_cast<double>(points_->size());
  // A beam adds 1 at most; what is explained after a row of beams that are not counts late only.
  const double slack = count * (1.0 - at_least);
  double sum = 0.0;
  ForEachExplainedBeam(world_T_robot, [&](std::size_t k, float squared_cells) {
    sum += std::exp(static_cast<float>(score_scale_) * squared_cells);
    return sum + slack >= static_cast<double>(k);
  });
  return sum / count;
}

double EndpointModel::LogLikelihood(const backend::SE2& world_T_robot) {
  const double limit = unmatched_squared_cells_;
  double sum = limit * static_cast<double>(points_->size());
  ForEachExplainedBeam(world_T_robot, [&](std::size_t, float squared_cells) {
    sum += std::min<double>(squared_cells, limit) - limit;
    return true;
  });
  return likelihood_scale_ * sum;
}

template <typename Visit>
void EndpointModel::ForEachExplainedBeam(const backend::SE2& world_T_robot, const Visit& visit) {
  const double cells_per_m = 1.0 / grid_->resolution_m();
  const double c = std::cos(world_T_robot.theta), s = std::sin(world_T_robot.theta);
  const double cx = c * cells_per_m, sx = s * cells_per_m;
  const double x0 = world_T_robot.x * cells_per_m, y0 = world_T_robot.y * cells_per_m;
  for (std::size_t beam = 0; beam < points_->size(); ++beam) {
    const ScanPoint& point = (*points_)[beam];
    const double x = x0 + cx * point.x_m - sx * point.y_m;
    const double y = y0 + sx * point.x_m + cx * point.y_m;
    const CellIndex end{FloorToCell(x), FloorToCell(y)};
    map::CellBlock& block = blocks_[beam];
    if (!block.Covers(end)) block.CopyFrom(*grid_, end);
    const float in_cell_x = static_cast<float>(x - end.x);
    const float in_cell_y = static_cast<float>(y - end.y);
    float nearest = kNothing;
    block.ForEachFullNeighbour(end, Sign(c * point.back_x - s * point.back_y),
                               Sign(s * point.back_x + c * point.back_y),
                               [&](float mean_x, float mean_y) {
                                 const float dx = in_cell_x - mean_x, dy = in_cell_y - mean_y;
                                 nearest = std::min(nearest, dx * dx + dy * dy);
                               });
    if (nearest < kNothing && !visit(beam, nearest)) return;
  }
}

}  // namespace gmapping_spa::scan_matching
