// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/endpoint_model.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontend/scan_matching/local_surface.h"

namespace gmapping_spa::scan_matching {

using map::CellIndex;
using map::FloorToCell;

namespace {

// A beam that ends this many cells behind a surface, or fewer, has crossed it.
constexpr int kCellsBehind = 12;

// Expected of a beam that fits, in squared standard deviations.
constexpr float kExpectedSquaredDistance = 1.0f;

// So many beams, evenly spread, tell the likelihood of a pose as well as all of a dense scan, whose
// neighbors see the same wall.
constexpr std::size_t kEnoughBeams = 90;

constexpr float kNothing = std::numeric_limits<float>::infinity();

// A component of a unit vector, rounded to the eight directions of a grid.
int Rounded(double component) { return (component > 0.5) - (component < -0.5); }

}  // namespace

EndpointModel::EndpointModel(const Options& options, const map::OccupancyGrid* grid,
                             const ScanPoints* points)
    : grid_(grid), points_(points), blocks_(points->size()) {
  CHECK_GT(options.score_sigma_m, 0.0);
  CHECK_GT(options.likelihood_sigma_m, 0.0);
  CHECK_GT(options.unmatched_sigmas, 0.0);
  CHECK_GT(options.likelihood_gain, 0.0);
  const double resolution_m = grid->resolution_m();
  score_scale_ = -0.5 * std::pow(resolution_m / options.score_sigma_m, 2);
  noise_cells_ = static_cast<float>(options.likelihood_sigma_m / resolution_m);
  likelihood_scale_ = -0.5 * options.likelihood_gain;
  max_squared_distance_ = static_cast<float>(std::pow(options.unmatched_sigmas, 2));
  unseen_is_miss_ = options.unseen_is_miss;
  likelihood_ = options.likelihood;
  free_cell_in_front_ = options.free_cell_in_front;
}

double EndpointModel::Score(const backend::SE2& world_T_robot, double at_least) {
  if (points_->empty()) return 0.0;
  const double count = static_cast<double>(points_->size());
  // A beam adds 1 at most; what is explained after a row of beams that are not counts late only.
  const double slack = count * (1.0 - at_least);
  double sum = 0.0;
  ForEachBeam(world_T_robot, 1, [&](std::size_t k, const EndPoint& end) {
    sum += Explained(end);
    return sum + slack >= static_cast<double>(k);
  });
  return sum / count;
}

Evidence EndpointModel::Evaluate(const backend::SE2& world_T_robot) {
  Evidence evidence;
  ForEachBeam(world_T_robot, 1, [&](std::size_t k, const EndPoint& end) {
    const double weight = (*points_)[k].weight;
    if (const double explained = Explained(end); explained > 0.0) {
      evidence.explained += weight * explained;
      evidence.at_surface += weight;
    } else if (IsUnknown(end)) {
      evidence.unknown += weight;
    } else {
      evidence.contradicted += weight;
    }
    return true;
  });
  return evidence;
}

float EndpointModel::SquaredDistanceToHit(const EndPoint& end) const {
  const auto x = static_cast<float>(end.x - end.cell.x);
  const auto y = static_cast<float>(end.y - end.cell.y);
  float nearest = kNothing;
  const auto compare = [&](float mean_x, float mean_y) {
    const float dx = x - mean_x, dy = y - mean_y;
    nearest = std::min(nearest, dx * dx + dy * dy);
  };
  if (free_cell_in_front_) {
    end.block->ForEachOccupiedNeighbor(end.cell, end.back_dx, end.back_dy, compare);
  } else {
    end.block->ForEachOccupiedNeighbor(end.cell, compare);
  }
  return nearest;
}

double EndpointModel::Explained(const EndPoint& end) const {
  const float nearest = SquaredDistanceToHit(end);
  return std::isfinite(nearest) ? std::exp(static_cast<float>(score_scale_) * nearest) : 0.0;
}

float EndpointModel::SquaredMahalanobis(const EndPoint& end) const {
  if (likelihood_ == Likelihood::kNearestHit) {
    return SquaredDistanceToHit(end) / (noise_cells_ * noise_cells_);
  }
  LocalSurface surface;
  if (!surface.Fit(*end.block, end.cell, end.x, end.y)) return kNothing;
  const Eigen::Vector2f weighted = surface.Information(noise_cells_) * surface.offset;
  return surface.offset.dot(weighted);
}

bool EndpointModel::IsUnknown(const EndPoint& end) const {
  if (grid_->cell(end.cell).visits > 0) return false;
  for (int k = 1; k <= kCellsBehind; ++k) {
    const CellIndex cell{FloorToCell(end.x + k * end.back_x), FloorToCell(end.y + k * end.back_y)};
    if (grid_->OccupiedBits(cell) & 1u) return false;
  }
  return true;
}

double EndpointModel::LogLikelihood(const backend::SE2& world_T_robot) {
  if (points_->empty()) return 0.0;
  // Plain GMapping takes all beams.
  const std::size_t stride =
      unseen_is_miss_ ? 1 : (points_->size() + kEnoughBeams - 1) / kEnoughBeams;
  double sum = 0.0;
  std::size_t beams = 0;
  ForEachBeam(world_T_robot, stride, [&](std::size_t, const EndPoint& end) {
    const float squared = SquaredMahalanobis(end);
    const bool says_nothing = squared == kNothing && !unseen_is_miss_ && IsUnknown(end);
    sum += says_nothing ? kExpectedSquaredDistance : std::min(max_squared_distance_, squared);
    ++beams;
    return true;
  });
  return likelihood_scale_ * sum * static_cast<double>(points_->size()) /
         static_cast<double>(beams);
}

template <typename Visit>
void EndpointModel::ForEachBeam(const backend::SE2& world_T_robot, std::size_t stride,
                                const Visit& visit) {
  const double cells_per_m = 1.0 / grid_->resolution_m();
  const double c = std::cos(world_T_robot.theta), s = std::sin(world_T_robot.theta);
  const double cx = c * cells_per_m, sx = s * cells_per_m;
  const double x0 = world_T_robot.x * cells_per_m, y0 = world_T_robot.y * cells_per_m;
  for (std::size_t k = 0; k < points_->size(); k += stride) {
    const ScanPoint& point = (*points_)[k];
    EndPoint end;
    end.x = x0 + cx * point.x_m - sx * point.y_m;
    end.y = y0 + sx * point.x_m + cx * point.y_m;
    end.cell = {FloorToCell(end.x), FloorToCell(end.y)};
    end.back_x = c * point.back_x - s * point.back_y;
    end.back_y = s * point.back_x + c * point.back_y;
    end.back_dx = Rounded(end.back_x);
    end.back_dy = Rounded(end.back_y);
    end.block = &blocks_.Around(*grid_, k, end.cell);
    if (!visit(k, end)) return;
  }
}

}  // namespace gmapping_spa::scan_matching
