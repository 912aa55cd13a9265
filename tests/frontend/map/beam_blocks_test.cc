// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/beam_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::map {
namespace {

constexpr int kBeams = 50;

OccupancyGrid RandomGrid() {
  OccupancyGrid grid({.resolution_m = 0.05, .occupied_threshold = 0.3});
  backend::CounterRandom random(1, 0);
  for (int k = 0; k < 600; ++k) grid.AddHit(60.0 * random.Uniform(), 60.0 * random.Uniform());
  return grid;
}

// Hit means in the 3 x 3 neighborhood, from the corner of the cell.
std::vector<float> Around(const CellBlock& block, CellIndex cell) {
  std::vector<float> means;
  block.ForEachOccupiedNeighbor(cell, 1, 0, [&](float x, float y) {
    means.push_back(x);
    means.push_back(y);
  });
  return means;
}

TEST(BeamBlocks, HoldWhatABlockOfItsOwnWouldHoldWhereverBeamsMove) {
  const OccupancyGrid grid = RandomGrid();
  BeamBlocks blocks(kBeams);
  backend::CounterRandom random(2, 0);
  int found = 0;
  for (int pose = 0; pose < 40; ++pose) {
    // Every other time only some of the beams, as for a likelihood.
    const int stride = 1 + pose % 3;
    const double off = 3.0 * random.Uniform(), turn = 0.2 * random.Uniform();
    for (int beam = 0; beam < kBeams; beam += stride) {
      const double angle = 0.05 * beam + turn;
      const CellIndex cell{FloorToCell(30.0 + off + 25.0 * std::cos(angle)),
                           FloorToCell(30.0 - off + 25.0 * std::sin(angle))};
      const CellBlock& block = blocks.Around(grid, beam, cell);
      ASSERT_TRUE(block.Covers(cell));
      CellBlock own;
      own.CopyFrom(grid, cell);
      const std::vector<float> expected = Around(own, cell), means = Around(block, cell);
      ASSERT_EQ(means.size(), expected.size());
      for (std::size_t k = 0; k < means.size(); ++k) EXPECT_NEAR(means[k], expected[k], 1e-5);
      found += static_cast<int>(means.size());
    }
  }
  EXPECT_GT(found, 500);
}

}  // namespace
}  // namespace gmapping_spa::map
