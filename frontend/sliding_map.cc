// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sliding_map.h"

#include <glog/logging.h>

#include <algorithm>
#include <bit>

#include "frontend/map/scan_insertion.h"
#include "frontend/scan_density.h"

namespace gmapping_spa::frontend {

using backend::SE2;

namespace {

// A search is made anew when the robot is this part of its reach away from where it was made.
constexpr double kRenewAt = 0.25;

// People leave hits in the map, which later beams clear; walls that are met at a flat angle stay.
constexpr double kClearMargin_m = 0.2;

// Hit means of the occupied cells within a square around the center.
std::vector<Eigen::Vector2d> Surfaces(const map::OccupancyGrid& grid, const SE2& center,
                                      double half_width_m) {
  const double resolution_m = grid.resolution_m();
  const map::OccupancyGrid::Extent extent = grid.KnownExtent();
  const auto cell = [&](double m) { return map::FloorToCell(m / resolution_m); };
  const int min_x = std::max(extent.min.x, cell(center.x - half_width_m));
  const int max_x = std::min(extent.max.x, cell(center.x + half_width_m));
  const int min_y = std::max(extent.min.y, cell(center.y - half_width_m));
  const int max_y = std::min(extent.max.y, cell(center.y + half_width_m));
  std::vector<Eigen::Vector2d> points;
  for (int y = min_y; y < max_y; ++y) {
    for (int x = min_x; x < max_x; x += 8) {
      for (std::uint32_t bits = grid.OccupiedBits({x, y}); bits != 0; bits &= bits - 1) {
        const int column = x + std::countr_zero(bits);
        const map::Cell& full = grid.cell({column, y});
        constexpr double kPerUnit = 1.0 / map::Cell::kMeanScale;
        points.emplace_back((column + kPerUnit * full.mean_x) * resolution_m,
                            (y + kPerUnit * full.mean_y) * resolution_m);
      }
    }
  }
  return points;
}

}  // namespace

SlidingMap::SlidingMap(const map::OccupancyGrid::Options& grid, int scans)
    : grid_options_(grid), scans_(scans) {
  CHECK_GE(scans, 2);
}

// Enters the scan into both maps. The second one is begun when the first is half full, and takes
// its place when that is full: the map in use always holds the last half.
void SlidingMap::Insert(const sensor::LaserScan& scan, const SE2& odom_T_robot) {
  if (maps_.empty() || maps_.back().scans >= 0.5 * scans_) {
    if (maps_.size() == 2) maps_.erase(maps_.begin());
    maps_.push_back({map::OccupancyGrid(grid_options_)});
  }
  for (LocalMap& local : maps_) {
    map::InsertScan(scan, odom_T_robot, {.clear_margin_m = kClearMargin_m}, &local.grid);
    local.scans += ScanDensity(scan);
  }
  searched_.reset();
  search_.reset();
}

void SlidingMap::Clear() {
  maps_.clear();
  searched_.reset();
  search_.reset();
}

const map::OccupancyGrid& SlidingMap::grid() const {
  CHECK(!maps_.empty());
  return maps_.front().grid;
}

const scan_matching::CorrelativeMatcher& SlidingMap::Search(
    const scan_matching::CorrelativeMatcher::Options& options, const SE2& odom_T_robot,
    double reach_m) {
  // A covered laser reaches less far than the next scan.
  const bool is_known =
      searched_ && Between(searched_->center, odom_T_robot).translation().norm() + reach_m <=
                       (1.0 + kRenewAt) * searched_->reach_m;
  if (!is_known) {
    searched_ = {odom_T_robot, reach_m};
    search_.reset();
  }
  if (!search_ || search_->options() != options) {
    search_ = std::make_unique<scan_matching::CorrelativeMatcher>(
        options, Surfaces(grid(), searched_->center, (1.0 + kRenewAt) * searched_->reach_m));
  }
  return *search_;
}

}  // namespace gmapping_spa::frontend
