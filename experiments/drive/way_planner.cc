// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/way_planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace gmapping_spa::drive {
namespace {

constexpr double kCellM = 0.1;
constexpr double kMarginM = 0.1;
// So near to start and goal, the margin may be missing.
constexpr double kNearEndsM = 0.5;
constexpr double kSameM = 0.05;

class Planner {
 public:
  Planner(const simulation::World& world, const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
          double radius_m)
      : world_(world), start_(start), goal_(goal), radius_m_(radius_m) {
    const map::TrinaryMap& raster = world.raster();
    origin_ = {raster.origin_x_m, raster.origin_y_m};
    columns_ = static_cast<int>(std::ceil(raster.width * raster.resolution_m / kCellM));
    rows_ = static_cast<int>(std::ceil(raster.height * raster.resolution_m / kCellM));
    const auto cells = static_cast<std::size_t>(columns_) * rows_;
    states_.assign(cells, kNotLookedAt);
    ways_m_.assign(cells, std::numeric_limits<double>::infinity());
    from_.assign(cells, -1);
  }

  simulation::WayPoints Plan() {
    const int first = CellOf(start_), last = CellOf(goal_);
    if (first < 0 || last < 0 || !IsFree(goal_) || !Search(first, last)) return {};
    simulation::WayPoints way = {goal_};
    for (int cell = from_[last]; cell >= 0 && cell != first; cell = from_[cell]) {
      way.push_back(CenterOf(cell));
    }
    way.push_back(start_);
    std::reverse(way.begin(), way.end());
    return Straightened(way);
  }

 private:
  static constexpr std::uint8_t kNotLookedAt = 2;

  int CellOf(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d cells = (point - origin_) / kCellM;
    const bool inside =
        cells.x() >= 0 && cells.y() >= 0 && cells.x() < columns_ && cells.y() < rows_;
    return inside ? static_cast<int>(cells.y()) * columns_ + static_cast<int>(cells.x()) : -1;
  }
  Eigen::Vector2d CenterOf(int cell) const {
    return origin_ + kCellM * Eigen::Vector2d(cell % columns_ + 0.5, cell / columns_ + 0.5);
  }
  bool IsFree(const Eigen::Vector2d& point) const {
    const bool is_near = std::min((point - start_).norm(), (point - goal_).norm()) < kNearEndsM;
    return !world_.FindContact(point, radius_m_ + (is_near ? 0.0 : kMarginM));
  }
  bool IsFreeCell(int cell) {
    if (states_[cell] == kNotLookedAt) states_[cell] = IsFree(CenterOf(cell)) ? 1 : 0;
    return states_[cell] == 1;
  }

  // A*; fills `from_`.
  bool Search(int first, int last) {
    using Entry = std::pair<double, int>;  // ways of equal length by cell: always the same way
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const Eigen::Vector2d end = CenterOf(last);
    ways_m_[first] = 0.0;
    open.emplace(0.0, first);
    while (!open.empty()) {
      const auto [estimate_m, cell] = open.top();
      open.pop();
      if (cell == last) return true;
      const double way_m = ways_m_[cell];
      if (estimate_m > way_m + (CenterOf(cell) - end).norm() + 1e-9) continue;  // of before
      for (int step_y = -1; step_y <= 1; ++step_y) {
        for (int step_x = -1; step_x <= 1; ++step_x) {
          const int column = cell % columns_ + step_x, row = cell / columns_ + step_y;
          if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
          const int next = row * columns_ + column;
          const double next_m = way_m + kCellM * std::hypot(step_x, step_y);
          if (next_m >= ways_m_[next] || (next != last && !IsFreeCell(next))) continue;
          ways_m_[next] = next_m;
          from_[next] = cell;
          open.emplace(next_m + (CenterOf(next) - end).norm(), next);
        }
      }
    }
    return false;
  }

  bool IsFreeBetween(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    const int steps = static_cast<int>(std::ceil((b - a).norm() / (kCellM / 2.0)));
    for (int i = 1; i < steps; ++i) {
      if (!IsFree(a + (b - a) * i / steps)) return false;
    }
    return true;
  }

  // Without those points that a straight line can leave out.
  simulation::WayPoints Straightened(const simulation::WayPoints& way) const {
    simulation::WayPoints straight = {way.front()};
    for (std::size_t i = 0; i + 1 < way.size();) {
      std::size_t next = i + 1;
      while (next + 1 < way.size() && IsFreeBetween(way[i], way[next + 1])) ++next;
      if ((way[next] - straight.back()).norm() > kSameM) straight.push_back(way[next]);
      i = next;
    }
    return straight.size() > 1 ? straight : simulation::WayPoints{};
  }

  const simulation::World& world_;
  Eigen::Vector2d start_, goal_, origin_;
  double radius_m_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> states_;  // 0 not free, 1 free
  std::vector<double> ways_m_;
  std::vector<int> from_;
};

}  // namespace

simulation::WayPoints PlanWay(const simulation::World& world, const Eigen::Vector2d& start,
                              const Eigen::Vector2d& goal, double radius_m) {
  return Planner(world, start, goal, radius_m).Plan();
}

}  // namespace gmapping_spa::drive
