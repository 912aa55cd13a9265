// SPDX-License-Identifier: BSD-3-Clause
// What MapHistory remembers between calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <vector>

#include "frontend/particle_filter/map_history.h"
#include "tests/frontend/particle_filter/map_history_world.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Maps = std::vector<map::OccupancyGrid>;

// A trunk of the steps 0 ... 13 and two leaves at step 16; snapshots hold 4, 8 and 12 steps.
class Snapshots : public testing::Test {
 protected:
  Snapshots() {
    grown_.Grow(13);
    grown_.Duplicate(0);
    grown_.Grow(3);
  }

  Maps Rebuild() {
    asked_.clear();
    return history_.Rebuild(grown_.tree, grown_.leaves, [this](int step) {
      asked_.insert(step);
      return CorridorScan(step);
    });
  }

  static std::multiset<int> StepsFrom(int first) {
    std::multiset<int> steps;
    for (int step = first; step <= 16; ++step) {
      steps.insert(step);
      if (step > 13) steps.insert(step);  // on two branches
    }
    return steps;
  }

  // The path of a leaf, but for the steps before `step`, which are those of `old`.
  Maps Mixed(const std::vector<std::vector<SE2>>& old, int step) const {
    Maps maps;
    for (std::size_t k = 0; k < old.size(); ++k) {
      std::vector<SE2> path = PosesOf(grown_.tree.Path(grown_.leaves[k]));
      std::copy(old[k].begin(), old[k].begin() + step, path.begin());
      maps.push_back(MapFromScratch(path, CorridorScan));
    }
    return maps;
  }

  std::vector<std::vector<SE2>> Paths() const {
    std::vector<std::vector<SE2>> paths;
    for (const TrajectoryTree::Index leaf : grown_.leaves) {
      paths.push_back(PosesOf(grown_.tree.Path(leaf)));
    }
    return paths;
  }

  GrownTree grown_{11};
  MapHistory history_{{.tolerance_m = 0.01, .tolerance_rad = 0.002, .snapshot_every = 4}, {}, {}};
  std::multiset<int> asked_;  // steps whose scans Rebuild wanted
};

TEST_F(Snapshots, FirstCallAsksForEveryStepAndTheNextForThoseAfterTheLastSnapshot) {
  EXPECT_TRUE(AreFromScratch(Rebuild(), grown_));
  EXPECT_EQ(asked_, StepsFrom(0));
  EXPECT_TRUE(AreFromScratch(Rebuild(), grown_));
  EXPECT_EQ(asked_, StepsFrom(12));
}

TEST_F(Snapshots, MovedPosesAreEnteredAgainFromTheLastSnapshotBeforeThem) {
  Rebuild();
  const struct {
    int moved, asked;  // first steps
  } table[] = {{14, 12}, {12, 12}, {11, 8}, {9, 8}, {8, 8}, {7, 4}, {3, 0}, {0, 0}};
  for (const auto& row : table) {
    grown_.MoveFrom(row.moved, {0.3, 0.1, 0.02});
    EXPECT_TRUE(AreFromScratch(Rebuild(), grown_)) << row.moved;
    EXPECT_EQ(asked_, StepsFrom(row.asked)) << row.moved;
    EXPECT_TRUE(AreFromScratch(Rebuild(), grown_)) << row.moved;  // by the new snapshots
    EXPECT_EQ(asked_, StepsFrom(12)) << row.moved;
  }
}

TEST_F(Snapshots, GrowWithTheTrunk) {
  Rebuild();
  grown_.leaves.pop_back();  // one branch dies out: the trunk now reaches step 16
  grown_.Grow(5);
  grown_.tree.Prune(&grown_.leaves);
  EXPECT_TRUE(AreFromScratch(Rebuild(), grown_));
  EXPECT_EQ(asked_, (std::multiset<int>{12, 13, 14, 15, 16, 17, 18, 19, 20, 21}));
  EXPECT_TRUE(AreFromScratch(Rebuild(), grown_));
  EXPECT_EQ(asked_, (std::multiset<int>{20, 21}));
}

TEST_F(Snapshots, OfATrunkThatWasLongerAreNotUsed) {
  GrownTree trunk(12), forked(12);  // the same random poses up to step 5
  trunk.Grow(13);
  forked.Grow(5);
  forked.Duplicate(0);
  forked.Grow(8);
  history_.Rebuild(trunk.tree, trunk.leaves, CorridorScan);
  EXPECT_TRUE(AreFromScratch(history_.Rebuild(forked.tree, forked.leaves, CorridorScan), forked));
}

TEST_F(Snapshots, PosesMovedLessThanTheToleranceStayAsTheyWereEntered) {
  Rebuild();
  const std::vector<std::vector<SE2>> old = Paths();
  grown_.MoveFrom(0, {0.006, 0.006, 0.0});  // together 8.5 mm
  const Maps maps = Rebuild();
  EXPECT_EQ(asked_, StepsFrom(12));
  const Maps expected = Mixed(old, 12);
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE(SameMap(maps[k], expected[k]));
    EXPECT_FALSE(SameMap(maps[k], grown_.FromScratch(k)));
  }
}

TEST_F(Snapshots, SmallMovesThatAddUpCount) {
  Rebuild();
  grown_.MoveFrom(6, {0.006, 0, 0});
  Rebuild();
  EXPECT_EQ(asked_, StepsFrom(12));
  grown_.MoveFrom(6, {0.006, 0, 0});  // 12 mm from where they were entered
  EXPECT_TRUE(AreFromScratch(Rebuild(), grown_));
  EXPECT_EQ(asked_, StepsFrom(4));
}

TEST_F(Snapshots, TurnsAloneCountToo) {
  Rebuild();
  const TrajectoryTree::Index at = 6;  // on the trunk: its step
  const SE2 pose = grown_.tree.vertices()[at].world_T_robot;
  grown_.tree.SetPose(at, {pose.x, pose.y, pose.theta - 0.0015});
  Rebuild();
  EXPECT_EQ(asked_, StepsFrom(12));
  grown_.tree.SetPose(at, {pose.x, pose.y, pose.theta - 0.0025});
  EXPECT_TRUE(AreFromScratch(Rebuild(), grown_));
  EXPECT_EQ(asked_, StepsFrom(4));
}

TEST_F(Snapshots, FullTurnIsNoMove) {
  const TrajectoryTree::Index at = 6;
  grown_.tree.SetPose(at, {3, 0, std::numbers::pi - 0.0005});
  Rebuild();
  grown_.tree.SetPose(at, {3, 0, -std::numbers::pi + 0.0005});
  Rebuild();
  EXPECT_EQ(asked_, StepsFrom(12));
}

TEST_F(Snapshots, MapsGivenOutMayBeWrittenTo) {
  Maps maps = Rebuild();
  for (map::OccupancyGrid& map : maps) map.AddHit(1.5, 2.5);
  EXPECT_TRUE(AreFromScratch(Rebuild(), grown_));
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
