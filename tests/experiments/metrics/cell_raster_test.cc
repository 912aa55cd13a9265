// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/cell_raster.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;

TEST(CellRaster, HoldsItsPointsInTheGridThatIsAskedFor) {
  const map::TrinaryMap raster = Rasterize({{-0.12, 0.33}, {0.26, 0.02}}, {0.01, 0.01}, 0.1);
  EXPECT_EQ(raster.width, 5);
  EXPECT_EQ(raster.height, 4);
  EXPECT_NEAR(raster.origin_x_m, -0.19, 1e-12);
  EXPECT_NEAR(raster.origin_y_m, 0.01, 1e-12);
  EXPECT_EQ(raster.at(0, 3), CellState::kOccupied);
  EXPECT_EQ(raster.at(4, 0), CellState::kOccupied);
  EXPECT_EQ(std::count(raster.cells.begin(), raster.cells.end(), CellState::kOccupied), 2);
}

TEST(CellRaster, OfNothingIsOneUnknownCell) {
  EXPECT_EQ(Rasterize({}, {0.0, 0.0}, 0.1).cells, std::vector<CellState>{CellState::kUnknown});
}

}  // namespace
}  // namespace gmapping_spa::metrics
