// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/session/archive.h"

#include <gtest/gtest.h>

#include <cereal/types/vector.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontend/map/occupancy_grid.h"
#include "frontend/session/plain_data.h"

namespace gmapping_spa::session {
namespace {

// A grid that says to hold so many tiles, from this one on, of which there are `tiles`.
map::OccupancyGrid LoadGrid(int first_x, int first_y, unsigned columns, unsigned rows,
                            std::size_t tiles) {
  SaveArchive save;
  save(first_x, first_y, columns, rows, std::vector<map::TilePtr>(tiles));
  const std::string bytes = save.TakeBytes();
  LoadArchive load(bytes);
  map::OccupancyGrid grid({});
  load(grid);
  return grid;
}

TEST(Archive, GridsThatNoScansMakeAreRefused) {
  EXPECT_NO_THROW(LoadGrid(0, 0, 0, 0, 0));
  EXPECT_NO_THROW(LoadGrid(-32768, 32767, 3, 1, 3));
  EXPECT_THROW(LoadGrid(0, 0, 3, 1, 2), std::runtime_error);
  EXPECT_THROW(LoadGrid(0, 0, 4000000000u, 0, 0), std::runtime_error);
  EXPECT_THROW(LoadGrid(2147483647, 0, 3, 1, 3), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::session
