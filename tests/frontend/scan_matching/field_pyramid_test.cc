// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/field_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::scan_matching {
namespace {

ByteGrid RandomField(std::uint32_t stream) {
  backend::CounterRandom random(2, stream);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 6; ++i) points.push_back({2.0 * random.Uniform(), 1.5 * random.Uniform()});
  return MakeLikelihoodField({.resolution_m = 0.05, .sigma_m = 0.03}, points);
}

TEST(FieldPyramid, LevelsAreMaximaOverTheSquaresOfTheirCells) {
  const ByteGrid field = RandomField(0);
  const FieldPyramid pyramid(field, 6);
  ASSERT_EQ(pyramid.levels(), 6);
  for (int h = 0; h < pyramid.levels(); ++h) {
    const int reach = FieldPyramid::Reach(h), size = 1 << h;
    for (int y = -70; y < 60; y += 3) {
      for (int x = -70; x < 70; x += 3) {
        int expected = 0;
        for (int j = y - reach; j < y + size + reach; ++j) {
          for (int i = x - reach; i < x + size + reach; ++i) {
            expected = std::max<int>(expected, field.value({i, j}));
          }
        }
        ASSERT_EQ(pyramid.level(h).value({x, y}), expected) << h << ": " << x << ' ' << y;
      }
    }
  }
}

TEST(FieldPyramid, BoundsTheFieldWhereverAPointComesToInABlockOfPoses) {
  const FieldPyramid pyramid(RandomField(1), 5);
  backend::CounterRandom random(3, 0);
  const double radius_cells = 20.0, step_rad = 1.0 / radius_cells;
  for (int trial = 0; trial < 20000; ++trial) {
    const int h = static_cast<int>(5 * random.Uniform()), size = 1 << h;
    // A point on its circle at the angles 0 to size - 1 of a block, and in their middle.
    const double start = 6.0 * random.Uniform(), x0 = 60.0 * random.Uniform() - 10.0;
    const auto cell_at = [&](double angle) {
      const double phi = start + angle * step_rad;
      return map::CellIndex{map::FloorToCell(x0 + radius_cells * std::cos(phi)),
                            map::FloorToCell(15.0 + radius_cells * std::sin(phi))};
    };
    const map::CellIndex middle = cell_at(0.5 * (size - 1));
    map::CellIndex cell = cell_at(static_cast<int>(size * random.Uniform()));
    cell.x += static_cast<int>(size * random.Uniform());
    cell.y += static_cast<int>(size * random.Uniform());
    ASSERT_LE(pyramid.level(0).value(cell), pyramid.level(h).value(middle));
  }
}

TEST(FieldPyramid, OfAnEmptyFieldIsZero) {
  const FieldPyramid pyramid(ByteGrid{}, 4);
  for (int h = 0; h < 4; ++h) EXPECT_EQ(pyramid.level(h).value({0, 0}), 0);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
