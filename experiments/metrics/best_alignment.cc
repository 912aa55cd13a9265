// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/best_alignment.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "experiments/metrics/closing.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

using backend::SE2;
using map::CellState;
using map::TrinaryMap;

constexpr double kReachOfFit_m = 0.25;

// How well a point fits the true map: 1 in an occupied cell, down to 0 in equal steps a cell.
class Fit {
 public:
  explicit Fit(const TrinaryMap& truth)
      : grid_(Framed(truth, Cells(truth))), fits_(grid_.cells.size(), 0) {
    steps_ = Cells(truth) + 1;
    TrinaryMap grown = grid_;
    for (int step = 0; step < steps_; ++step) {
      if (step > 0) grown = Dilated(grown);
      for (std::size_t i = 0; i < fits_.size(); ++i) {
        fits_[i] += grown.cells[i] == CellState::kOccupied;
      }
    }
  }

  double Sum(const std::vector<Eigen::Vector2d>& points, const SE2& truth_T_map) const {
    std::ptrdiff_t sum = 0;
    for (const Eigen::Vector2d& point : points) {
      const Eigen::Vector2d cell = ToCells(grid_, truth_T_map * point);
      const int column = CellOf(cell.x()), row = CellOf(cell.y());
      if (column < 0 || column >= grid_.width || row < 0 || row >= grid_.height) continue;
      sum += fits_[static_cast<std::size_t>(row) * grid_.width + column];
    }
    return static_cast<double>(sum) / steps_;
  }

 private:
  static int Cells(const TrinaryMap& truth) {
    return std::max(1, static_cast<int>(std::lround(kReachOfFit_m / truth.resolution_m)));
  }

  TrinaryMap grid_;
  std::vector<int> fits_;
  int steps_ = 1;
};

}  // namespace

SE2 FindBestAlignment(const TrinaryMap& truth, const TrinaryMap& map,
                      const std::vector<SE2>& candidates) {
  if (candidates.empty()) throw std::invalid_argument("best alignment: expected a candidate");
  const std::vector<Eigen::Vector2d> points = OccupiedCenters(map);
  if (points.empty()) return candidates.front();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  const SE2 map_T_middle{mean.x(), mean.y(), 0.0};

  const Fit fit(truth);
  const auto climbed = [&](SE2 best) {
    double most = fit.Sum(points, best);
    constexpr double kFirst_m = 0.25, kLast_m = 0.01, kRadPerM = 0.2;
    for (double step_m = kFirst_m; step_m > kLast_m;) {
      SE2 next = best;
      for (const SE2& step :
           {SE2{step_m, 0, 0}, SE2{-step_m, 0, 0}, SE2{0, step_m, 0}, SE2{0, -step_m, 0},
            SE2{0, 0, kRadPerM * step_m}, SE2{0, 0, -kRadPerM * step_m}}) {
        // About the middle of the map, where turning moves it least.
        const SE2 moved = best * map_T_middle * step * Inverse(map_T_middle);
        const double sum = fit.Sum(points, moved);
        if (sum <= most) continue;
        most = sum;
        next = moved;
      }
      if (next == best) step_m *= 0.5;
      best = next;
    }
    return std::pair(most, best);
  };
  std::pair<double, SE2> best = climbed(candidates.front());
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const auto other = climbed(candidates[i]);
    if (other.first > best.first) best = other;
  }
  return best.second;
}

}  // namespace gmapping_spa::metrics
