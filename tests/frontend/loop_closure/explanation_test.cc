// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/explanation.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

class Explained : public testing::Test {
 protected:
  ScanOfNode ScansIn(const synthetic::Walls& walls, synthetic::Laser laser = {}) const {
    return [this, walls, laser](int node) { return synthetic::Scan(walls, poses_[node], laser); };
  }
  double Usual(const ScanOfNode& scans, NodeRange nodes) const {
    return UsualInlierRatio(poses_, scans, nodes, 2, 0.1, {}, gauss_newton_);
  }

  const std::vector<SE2> poses_ = {
      {-1, -1, 0.2}, {0, -1, 0.5}, {1, -0.5, 1.2}, {1.2, 0.5, 1.8}, {0.3, 1, 2.9}};
  const scan_matching::GaussNewton gauss_newton_{{}};
};

TEST_F(Explained, AllOfAScanInItsOwnMapAndLessOfItBesideIt) {
  const ScanOfNode scans = ScansIn(synthetic::Room());
  const map::OccupancyGrid map = BuildLocalMap(poses_, scans, {2, 2}, 2, {});
  const scan_matching::ScanPoints points = JoinScans(poses_, scans, {2, 2}, 2, 0.1);
  EXPECT_GT(Overlap(map, points, SE2{}), 0.95);
  EXPECT_GT(Explain(map, points, SE2{}, 0.5, 1).part(), 0.95);
  const Explanation beside = Explain(map, points, SE2{-0.3, 0.0, 0.4}, 0.5, 1);
  EXPECT_GT(beside.known, 20);
  EXPECT_LT(beside.part(), 0.5);
  EXPECT_LT(Overlap(map, points, SE2{50.0, 0.0, 0.0}), 0.01);
  EXPECT_EQ(Explain(map, points, SE2{50.0, 0.0, 0.0}, 0.5, 1).part(), 0.0);
  EXPECT_EQ(Overlap(map, {}, SE2{}), 0.0);
}

TEST_F(Explained, ScansOfABuildingThatStandsStillExplainEachOther) {
  EXPECT_GT(Usual(ScansIn(synthetic::Room()), {0, 4}), 0.85);
}

TEST_F(Explained, ScansOfWhatMovesExplainEachOtherLess) {
  const ScanOfNode still = ScansIn(synthetic::Room());
  const ScanOfNode moving = [&](int node) {
    sensor::LaserScan scan = still(node);
    for (std::size_t k = 0; k < scan.beams.size(); ++k) {
      if ((k / 6 + 5 * node) % 3 == 0) scan.beams[k].range_m *= 0.4 + 0.1 * node;
    }
    return scan;
  };
  const double usual = Usual(moving, {0, 4});
  EXPECT_LT(usual, 0.75);
  EXPECT_GT(usual, 0.4);
}

TEST_F(Explained, OneScanOrBlindOnesDoNotTellWhatIsUsual) {
  EXPECT_EQ(Usual(ScansIn(synthetic::Room()), {2, 2}), 1.0);
  EXPECT_EQ(Usual([](int) { return sensor::LaserScan{}; }, {0, 4}), 1.0);
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
