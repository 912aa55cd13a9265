// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/map_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/frontend/particle_filter/map_history_world.h"

namespace gmapping_spa::particle_filter {
namespace {

using Maps = std::vector<map::OccupancyGrid>;

Maps Rebuilt(const GrownTree& grown, int snapshot_every = 50) {
  MapHistory history({.snapshot_every = snapshot_every}, {}, {});
  return history.Rebuild(grown.tree, grown.leaves, CorridorScan);
}

TEST(MapHistory, MapOfALonelyPathIsThatFromScratch) {
  for (const int steps : {0, 1, 7}) {
    GrownTree grown(1);
    grown.Grow(steps);
    for (const int snapshot_every : {1, 4, 50}) {
      EXPECT_TRUE(AreFromScratch(Rebuilt(grown, snapshot_every), grown)) << steps;
    }
  }
}

TEST(MapHistory, MapsOfABranchingTreeAreThoseFromScratch) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    GrownTree grown(seed);
    grown.Grow(3);
    for (int fork = 0; fork < 4; ++fork) {
      grown.Duplicate(
          static_cast<int>(grown.random.Uniform() * static_cast<double>(grown.leaves.size())));
      grown.Grow(static_cast<int>(3 * grown.random.Uniform()));  // 0: a triplet, perhaps
    }
    const Maps maps = Rebuilt(grown, 2);
    ASSERT_TRUE(AreFromScratch(maps, grown)) << seed;
  }
}

TEST(MapHistory, MapsOfDifferentLeavesDiffer) {  // or else the cases above would say little
  GrownTree grown(1);
  grown.Grow(3);
  grown.Duplicate(0);
  grown.Grow();
  const Maps maps = Rebuilt(grown);
  EXPECT_FALSE(SameMap(maps[0], maps[1]));
}

TEST(MapHistory, ForkAtTheRootIsWhereTheTrunkEnds) {
  GrownTree grown(2);
  grown.Duplicate(0);
  grown.Duplicate(0);
  grown.Grow(4);
  EXPECT_TRUE(AreFromScratch(Rebuilt(grown, 1), grown));
}

TEST(MapHistory, LineagesThatDiedOutDoNotMatter) {
  GrownTree grown(3);
  grown.Grow(2);
  grown.Duplicate(0);
  grown.Grow(2);
  grown.leaves.erase(grown.leaves.begin());
  grown.Grow(2);
  EXPECT_TRUE(AreFromScratch(Rebuilt(grown, 1), grown));  // not pruned
  grown.tree.Prune(&grown.leaves);
  EXPECT_TRUE(AreFromScratch(Rebuilt(grown, 1), grown));
}

TEST(MapHistory, EntersASharedHistoryOnce) {
  GrownTree grown(4);
  grown.Grow(5);
  grown.Duplicate(0);
  grown.Duplicate(0);
  grown.Grow(2);
  grown.Duplicate(1);  // twins
  std::vector<int> asked;
  MapHistory history({}, {}, {});
  history.Rebuild(grown.tree, grown.leaves, [&](int step) {
    asked.push_back(step);
    return CorridorScan(step);
  });
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(asked, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 6, 6, 7, 7, 7}));
}

TEST(MapHistory, LeavesShareTheTilesOfTheirSharedHistory) {
  GrownTree grown(5);
  grown.Grow(40);
  grown.Duplicate(0);
  grown.Grow(1);
  const Maps maps = Rebuilt(grown);
  for (const map::OccupancyGrid& map : maps) {
    EXPECT_GT(map.CountOwnTiles(), 0u);
    EXPECT_LT(map.CountOwnTiles(), map.CountTiles() / 4);
  }
}

TEST(MapHistory, TwinsShareOneLeafAndAllTiles) {
  GrownTree grown(6);
  grown.Grow(3);
  grown.Duplicate(0);
  grown.Grow(2);
  grown.Duplicate(1);
  grown.Duplicate(1);  // leaves: one, and three times the other
  const Maps maps = Rebuilt(grown);
  ASSERT_TRUE(AreFromScratch(maps, grown));
  EXPECT_GT(maps[0].CountOwnTiles(), 0u);
  for (const int twin : {1, 2, 3}) EXPECT_EQ(maps[twin].CountOwnTiles(), 0u);
}

TEST(MapHistory, TwinsOnTheTrunkGetItsMap) {
  GrownTree grown(7);
  grown.Grow(5);
  grown.Duplicate(0);
  const Maps maps = Rebuilt(grown);
  ASSERT_TRUE(AreFromScratch(maps, grown));
  EXPECT_EQ(maps[0].CountOwnTiles(), 0u);
}

TEST(MapHistory, RegistersScansAsItWasTold) {
  GrownTree grown(8);
  grown.Grow(2);
  map::OccupancyGrid expected({.resolution_m = 0.1});
  for (const TrajectoryTree::Vertex& vertex : grown.tree.vertices()) {
    map::InsertScan(CorridorScan(vertex.step), vertex.world_T_robot, {.no_return_clears = true},
                    &expected);
  }
  MapHistory history({}, {.resolution_m = 0.1}, {.no_return_clears = true});
  const Maps maps = history.Rebuild(grown.tree, grown.leaves, CorridorScan);
  EXPECT_EQ(maps[0].resolution_m(), 0.1);
  EXPECT_TRUE(SameMap(maps[0], expected));
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
