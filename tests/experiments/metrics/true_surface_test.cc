// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/true_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics::true_surface_test {
namespace {

using map::CellState;

std::vector<SurfaceElement> Surface(const map::TrinaryMap& truth,
                                    const std::vector<Eigen::Vector2d>& positions) {
  backend::Trajectory poses;
  for (const Eigen::Vector2d& p : positions) poses.push_back({0.0, {p.x(), p.y(), 0.0}});
  return FindSeenSurface(truth, LookAround(truth, poses, 30.0));
}

int CountStraight(const std::vector<SurfaceElement>& surface) {
  return static_cast<int>(std::count_if(surface.begin(), surface.end(),
                                        [](const auto& e) { return e.across.has_value(); }));
}

// Free space of 30 x 20 cells from (0.1, 0.1) with a wall of one cell around it.
map::TrinaryMap Room() {
  map::TrinaryMap map = UnknownMap(34, 24);
  Fill(1, 1, 33, 23, CellState::kOccupied, &map);
  Fill(2, 2, 32, 22, CellState::kFree, &map);
  return map;
}

TEST(TrueSurface, IsEveryEdgeBetweenAWallAndSeenFreeSpace) {
  const auto surface = Surface(Room(), {{0.83, 0.61}});
  EXPECT_EQ(surface.size(), 2 * 30 + 2 * 20);
  for (const SurfaceElement& element : surface) {
    EXPECT_NEAR((element.edge.to - element.edge.from).norm(), 0.05, 1e-12);
  }
  // The first one is the lower left: its edge is the top of the wall cell.
  EXPECT_NEAR(surface.front().middle().x(), 0.125, 1e-12);
  EXPECT_NEAR(surface.front().middle().y(), 0.1, 1e-12);
}

TEST(TrueSurface, IsStraightAwayFromCorners) {
  const auto surface = Surface(Room(), {{0.83, 0.61}});
  // Next to a corner, three cells a side are not: the wall around the corner is within reach.
  EXPECT_EQ(CountStraight(surface), 2 * (30 - 6) + 2 * (20 - 6));
  for (const SurfaceElement& element : surface) {
    if (!element.across) continue;
    const Eigen::Vector2d inward = Eigen::Vector2d(0.85, 0.6) - element.middle();
    EXPECT_GT(element.across->normal.dot(inward), 0.0);
    EXPECT_NEAR(element.across->normal.cwiseAbs().maxCoeff(), 1.0, 1e-12) << "parallel to an axis";
    EXPECT_NEAR(element.across->behind_m, kReach_m, 1e-9);
    EXPECT_NEAR(element.across->half_length_m, 0.1, 1e-12);
  }
}

TEST(TrueSurface, ReachesHalfWayIntoAThinWallAndANarrowGap) {
  // From bottom to top: solid, a gap of 8 cells, a wall of 2, 12 free cells.
  map::TrinaryMap map = UnknownMap(40, 30);
  Fill(0, 0, 40, 1, CellState::kOccupied, &map);
  Fill(0, 1, 40, 9, CellState::kFree, &map);
  Fill(0, 9, 40, 11, CellState::kOccupied, &map);
  Fill(0, 11, 40, 23, CellState::kFree, &map);
  const auto both_sides = Surface(map, {{1.0, 0.25}, {1.0, 0.95}});
  int checked = 0;
  for (const SurfaceElement& element : both_sides) {
    if (!element.across) continue;
    const double y = element.middle().y();
    const bool below = std::abs(y - 0.45) < 1e-9, above = std::abs(y - 0.55) < 1e-9;
    if (!below && !above) continue;
    EXPECT_NEAR(element.across->behind_m, 0.05, 1e-9);
    EXPECT_NEAR(element.across->in_front_m, below ? 0.2 : 0.3, 1e-9);
    ++checked;
  }
  EXPECT_EQ(checked, 2 * 36);
  // Where the other side was never seen, all that is behind belongs to this one.
  for (const SurfaceElement& element : Surface(map, {{1.0, 0.95}})) {
    if (element.across) {
      EXPECT_NEAR(element.across->behind_m, kReach_m, 1e-9);
    }
  }
}

TEST(TrueSurface, OfASlantedWallHasTheNormalOfTheWall) {
  for (const double angle_deg : {10.0, 26.57, 45.0, 70.0}) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    const Eigen::Vector2d normal(-std::sin(angle), std::cos(angle)), point(1.5, 1.5);
    map::TrinaryMap map = UnknownMap(60, 60);
    for (int row = 0; row < 60; ++row) {
      for (int column = 0; column < 60; ++column) {
        const double height = (CellCenter(map, column, row) - point).dot(normal);
        map.at(column, row) = height > 0.0 ? CellState::kFree : CellState::kOccupied;
      }
    }
    const auto surface = Surface(map, {point + 0.5 * normal, point + 1.2 * normal});
    EXPECT_GT(CountStraight(surface), 0.5 * surface.size()) << angle_deg;
    for (const SurfaceElement& element : surface) {
      if (element.across) {
        EXPECT_GT(element.across->normal.dot(normal), std::cos(0.2)) << angle_deg;
      }
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::metrics::true_surface_test
