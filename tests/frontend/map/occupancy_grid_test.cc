// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/occupancy_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <thread>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::map {
namespace {

OccupancyGrid Empty() { return OccupancyGrid({}); }

bool SameCell(const Cell& a, const Cell& b) {
  return a.hits == b.hits && a.visits == b.visits && a.mean_x == b.mean_x && a.mean_y == b.mean_y;
}

// Whether all cells and occupied bits of [-size, size) x [-size, size) are the same.
bool Same(const OccupancyGrid& a, const OccupancyGrid& b, int size) {
  for (int y = -size; y < size; ++y) {
    for (int x = -size; x < size; ++x) {
      if (!SameCell(a.cell({x, y}), b.cell({x, y}))) return false;
      if (a.OccupiedBits({x, y}) != b.OccupiedBits({x, y})) return false;
    }
  }
  return true;
}

// Random beams, all within 100 cells of the origin.
void AddBeams(std::uint32_t seed, int count, OccupancyGrid* grid) {
  backend::CounterRandom random(seed, 0);
  const auto coordinate = [&] { return 200.0 * random.Uniform() - 100.0; };
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate();
    grid->AddPasses({FloorToCell(coordinate()), FloorToCell(coordinate())},
                    {FloorToCell(x), FloorToCell(y)});
    grid->AddHit(x, y);
  }
}

TEST(FloorToCell, IsFloorOnBothSidesOfZero) {
  for (const double x : {-524287.5, -1000.25, -1.0, -0.75, -1e-6, 0.0, 1e-6, 0.999, 1.0, 524287.5})
    EXPECT_EQ(FloorToCell(x), std::floor(x)) << x;
}

TEST(OccupancyGrid, IsEmptyWhereNoBeamHasBeen) {
  OccupancyGrid grid = Empty();
  EXPECT_EQ(grid.cell({0, 0}).visits, 0);
  EXPECT_EQ(grid.OccupiedBits({-5, 7}), 0u);
  EXPECT_EQ(grid.CountTiles(), 0u);
  EXPECT_TRUE(grid.KnownExtent().min == grid.KnownExtent().max);
  grid.AddHit(3.5, 4.5);
  EXPECT_EQ(grid.cell({1000, -1000}).visits, 0);
}

TEST(OccupancyGrid, PassesGoUpToButWithoutTheEnd) {
  OccupancyGrid grid = Empty();
  grid.AddPasses({-3, 2}, {4, 2});
  for (int x = -3; x < 4; ++x) EXPECT_EQ(grid.cell({x, 2}).visits, 1) << x;
  EXPECT_EQ(grid.cell({4, 2}).visits, 0);
  EXPECT_EQ(grid.cell({-4, 2}).visits, 0);
}

TEST(OccupancyGrid, PassesStayNearTheLineInEveryDirection) {
  backend::CounterRandom random(1, 0);
  for (int trial = 0; trial < 200; ++trial) {
    const CellIndex from{static_cast<int>(60 * random.Uniform()) - 30, -7};
    const CellIndex to{static_cast<int>(60 * random.Uniform()) - 30,
                       static_cast<int>(60 * random.Uniform()) - 30};
    OccupancyGrid grid = Empty();
    grid.AddPasses(from, to);
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    int visited = 0;
    for (int y = -40; y < 40; ++y) {
      for (int x = -40; x < 40; ++x) {
        if (grid.cell({x, y}).visits == 0) continue;
        ++visited;
        EXPECT_LE(std::abs(dx * (y - from.y) - dy * (x - from.x)) / length, 0.5 + 1e-9);
      }
    }
    EXPECT_EQ(visited, std::max(std::abs(dx), std::abs(dy)));  // one a step, none left out
  }
}

TEST(OccupancyGrid, HitMeanIsRelativeToTheCornerOfItsCell) {
  OccupancyGrid grid = Empty();
  grid.AddHit(-7.75, 20.5);
  const Cell& cell = grid.cell({-8, 20});
  EXPECT_EQ(cell.hits, 1);
  EXPECT_EQ(cell.mean_x, Cell::kMeanScale / 4);
  EXPECT_EQ(cell.mean_y, Cell::kMeanScale / 2);
}

TEST(OccupancyGrid, GrowsInEveryDirectionAndKeepsWhatItHas) {
  const std::vector<CellIndex> cells = {{0, 0},    {-5000, 3}, {7, -5000}, {5000, -2},
                                        {4, 5000}, {-80, -80}, {80, 80},   {-5000, 5000}};
  OccupancyGrid grid = Empty();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    grid.AddHit(cells[k].x + 0.5, cells[k].y + 0.25);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      EXPECT_EQ(grid.cell(cells[i]).hits, i <= k ? 1 : 0) << "cell " << i << " after " << k;
    }
  }
  EXPECT_EQ(grid.CountTiles(), cells.size());
  const OccupancyGrid::Extent extent = grid.KnownExtent();
  EXPECT_TRUE((extent.min == CellIndex{-5008, -5008}));  // whole tiles of 16
  EXPECT_TRUE((extent.max == CellIndex{5008, 5008}));
}

TEST(OccupancyGrid, ReachesTheLastCellItPromises) {
  for (const int end : {-kMaxCellIndex + 1, kMaxCellIndex - 1}) {
    OccupancyGrid grid = Empty();
    grid.AddPasses({end, end}, {end - (end > 0 ? 40 : -40), end});
    EXPECT_EQ(grid.cell({end, end}).visits, 1);
    EXPECT_EQ(grid.cell({end - (end > 0 ? 39 : -39), end}).visits, 1);
  }
}

TEST(OccupancyGrid, CopyAndOriginalDoNotSeeEachOthersWrites) {
  OccupancyGrid original = Empty();
  AddBeams(1, 50, &original);
  OccupancyGrid reference = Empty();
  AddBeams(1, 50, &reference);

  OccupancyGrid copy = original;
  AddBeams(2, 50, &copy);
  EXPECT_TRUE(Same(original, reference, 110));
  EXPECT_FALSE(Same(copy, reference, 110));

  const OccupancyGrid copy_of_copy = copy;
  AddBeams(3, 50, &copy);
  AddBeams(2, 50, &reference);
  EXPECT_TRUE(Same(copy_of_copy, reference, 110));
}

TEST(OccupancyGrid, CopySharesAllTilesButThoseWrittenTo) {
  OccupancyGrid grid = Empty();
  for (int i = 0; i < 5; ++i) grid.AddHit(16.0 * i + 0.5, 0.5);
  EXPECT_EQ(grid.CountOwnTiles(), 5u);
  {
    OccupancyGrid copy = grid;
    EXPECT_EQ(grid.CountOwnTiles(), 0u);
    EXPECT_EQ(copy.CountTiles(), 5u);
    copy.AddHit(16.5, 1.5);  // a tile both have
    EXPECT_EQ(copy.CountOwnTiles(), 1u);
    EXPECT_EQ(grid.CountOwnTiles(), 1u);
    copy.AddHit(16.5, 2.5);  // is its own now
    EXPECT_EQ(copy.CountOwnTiles(), 1u);
    copy.AddHit(0.5, 40.5);  // a new tile
    EXPECT_EQ(copy.CountOwnTiles(), 2u);
    EXPECT_EQ(copy.CountTiles(), 6u);
  }
  EXPECT_EQ(grid.CountOwnTiles(), 5u);
  EXPECT_EQ(grid.CountTiles(), 5u);
}

TEST(OccupancyGrid, TileOfACopyIsAnotherOneOnlyWhereSomethingHasChanged) {
  OccupancyGrid grid(OccupancyGrid::Options{});
  grid.AddHit(-0.5, 0.5);
  grid.AddHit(20.5, 0.5);
  const OccupancyGrid copy = grid;
  grid.AddHit(20.5, 0.5);
  EXPECT_NE(grid.FindTile(-1, 0), nullptr);
  EXPECT_EQ(grid.FindTile(-1, 0), copy.FindTile(-1, 0));
  EXPECT_NE(grid.FindTile(1, 0), copy.FindTile(1, 0));
  EXPECT_EQ(grid.FindTile(0, 1), nullptr);
  EXPECT_EQ(grid.FindTile(1000, -1000), nullptr);
}

TEST(OccupancyGrid, WritingToOneGridOfManyIsSafeWhileThreadsWriteToTheOthers) {
  // Every thread takes copies of one grid, writes to them and drops them, so that reference counts
  // rise and fall everywhere while others decide whether a tile is theirs alone.
  constexpr int kThreads = 4, kRounds = 8;
  OccupancyGrid base = Empty();
  AddBeams(100, 40, &base);
  std::vector<OccupancyGrid> parallel(kThreads, base), serial(kThreads, base);
  const auto work = [&base](int index, OccupancyGrid* grid) {
    for (int round = 0; round < kRounds; ++round) {
      OccupancyGrid scratch = *grid;
      AddBeams(1000 + index, 5, &scratch);
      AddBeams(10 * index + round, 10, grid);
      scratch = base;
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(kThreads);
  for (int i = 0; i < kThreads; ++i) threads.emplace_back(work, i, &parallel[i]);
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < kThreads; ++i) {
    work(i, &serial[i]);
    EXPECT_TRUE(Same(parallel[i], serial[i], 110)) << "grid " << i;
  }
}

TEST(OccupancyGrid, FullBitsSayWhichCellsAreAboveTheThreshold) {
  OccupancyGrid grid({.resolution_m = 0.05, .occupied_threshold = 0.25});
  AddBeams(5, 4000, &grid);
  int occupied = 0, known = 0;
  for (int y = -104; y < 104; ++y) {
    for (int x = -120; x < 104; ++x) {  // starts and ends outside, crosses all tile borders
      std::uint32_t expected = 0;
      for (int bit = 0; bit < 8; ++bit) {
        const Cell& cell = grid.cell({x + bit, y});
        if (cell.hits > 0.25 * cell.visits) expected |= 1u << bit;
      }
      ASSERT_EQ(grid.OccupiedBits({x, y}), expected) << x << " " << y;
      occupied += static_cast<int>(expected & 1);
      known += grid.cell({x, y}).hits > 0;
    }
  }
  EXPECT_GT(occupied, 100);
  EXPECT_GT(known - occupied, 100);  // hit, but passed too often
}

}  // namespace
}  // namespace gmapping_spa::map
