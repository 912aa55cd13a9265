// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/api/slam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "frontend/slam_parts.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa {
namespace {

using backend::SE2;

class NoOptimizer : public backend::Optimizer {
 public:
  backend::Summary Optimize(const backend::Options&, std::span<const backend::Edge>,
                            std::span<backend::Node>) override {
    backend::Summary summary;
    summary.termination = backend::Termination::kConverged;
    return summary;
  }
};

// Of a robot that drives an arc in a room.
sensor::LaserScan Scan(int k) {
  sensor::LaserScan scan =
      synthetic::Scan(synthetic::Room(), {0.1 * k, 0.02 * k, 0.04 * k}, {.beams = 181});
  scan.stamp_s = 0.1 * k;
  return scan;
}

class SlamTest : public testing::Test {
 protected:
  static SlamOptions Options() {
    SlamOptions options;
    options.linear_update_m = 0.5;
    return options;
  }

  void Drive(int scans) {
    for (int k = 0; k < scans; ++k) last_ = slam_.AddScan(Scan(k));
  }

  Slam slam_{Options(), std::make_shared<NoOptimizer>()};
  ScanResult last_;
};

TEST_F(SlamTest, TellsWhereTheRobotIs) {
  Drive(20);
  EXPECT_EQ(slam_.CurrentPose(), last_.world_T_robot);
  EXPECT_FALSE(last_.lost);
  const SE2 error = Between(SE2{1.9, 0.38, 0.76}, last_.world_T_robot);
  EXPECT_LT(error.translation().norm(), 0.02);
  EXPECT_LT(std::abs(error.theta), 0.01);
}

TEST_F(SlamTest, NumbersScansItself) {
  for (int k = 0; k < 20; ++k) {
    sensor::LaserScan scan = Scan(k);
    scan.index = 100 - k;
    const ScanResult result = slam_.AddScan(scan);
    const backend::Trajectory trajectory = slam_.CurrentTrajectory();
    ASSERT_EQ(trajectory.size(), k + 1U);
    EXPECT_EQ(trajectory.back().stamp_s, scan.stamp_s);
    EXPECT_LT(Between(trajectory.back().world_T_robot, result.world_T_robot).translation().norm(),
              1e-9);
  }
}

TEST_F(SlamTest, AnUpdateIsANodeOfTheGraph) {
  std::size_t updates = 0;
  for (int k = 0; k < 20; ++k) {
    updates += slam_.AddScan(Scan(k)).updated ? 1 : 0;
    EXPECT_EQ(slam_.CurrentGraph().nodes.size(), updates);
  }
  EXPECT_GT(updates, 3U);
  EXPECT_LT(updates, 10U);
}

TEST_F(SlamTest, IsWhatTheExecutableRuns) {
  frontend::ImprovedGmapping expected(
      frontend::GmappingOptions(Options()), frontend::MakeScanMatcher(Options()),
      frontend::BindOptimizer(Options(), std::make_shared<NoOptimizer>()));
  for (int k = 0; k < 20; ++k) {
    sensor::LaserScan scan = Scan(k);
    scan.index = k;
    expected.AddScan(scan);
  }
  Drive(20);
  slam_.Finish();
  const backend::Trajectory trajectory = slam_.CurrentTrajectory();
  const backend::Trajectory expected_trajectory = expected.Finish().trajectory;
  ASSERT_EQ(trajectory.size(), expected_trajectory.size());
  for (std::size_t k = 0; k < trajectory.size(); ++k) {
    EXPECT_EQ(trajectory[k].world_T_robot, expected_trajectory[k].world_T_robot);
  }
}

TEST_F(SlamTest, HasAMapAtAnyTimeAndOneOfAllScansInTheEnd) {
  Drive(1);
  const map::TrinaryMap first = slam_.CurrentMap();
  EXPECT_GT(first.width, 100);
  slam_ = Slam(Options(), std::make_shared<NoOptimizer>());
  Drive(20);
  const map::TrinaryMap before = slam_.CurrentMap();
  slam_.Finish();
  const map::TrinaryMap after = slam_.CurrentMap();
  const auto occupied = [](const map::TrinaryMap& map) {
    return std::count(map.cells.begin(), map.cells.end(), map::CellState::kOccupied);
  };
  EXPECT_GT(occupied(after), 200);
  EXPECT_GT(occupied(before), 200);
  EXPECT_EQ(slam_.CurrentPose(), slam_.CurrentTrajectory().back().world_T_robot);
}

TEST_F(SlamTest, RefusesWhatMakesNoSenseAndGoesOn) {
  EXPECT_THROW(slam_.CurrentPose(), std::logic_error);
  EXPECT_THROW(slam_.CurrentMap(), std::logic_error);
  EXPECT_THROW(slam_.Finish(), std::logic_error);
  EXPECT_THROW(Slam({.particles = 0}), std::invalid_argument);
  EXPECT_THROW(Slam(Options(), nullptr), std::invalid_argument);
  SlamOptions no_such;
  no_such.backend = "no_such_back_end";
  EXPECT_THROW(Slam{no_such}, std::runtime_error);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  sensor::LaserScan scan = Scan(0);
  scan.stamp_s = nan;
  EXPECT_THROW(slam_.AddScan(scan), std::invalid_argument);
  scan = Scan(0);
  scan.odom_T_robot.theta = nan;
  EXPECT_THROW(slam_.AddScan(scan), std::invalid_argument);
  scan = Scan(0);
  scan.beams[3].range_m = nan;
  EXPECT_THROW(slam_.AddScan(scan), std::invalid_argument);
  Drive(2);
  EXPECT_EQ(slam_.CurrentTrajectory().size(), 2U);
  slam_.Finish();
  EXPECT_NO_THROW(slam_.Finish());
  EXPECT_THROW(slam_.AddScan(Scan(3)), std::logic_error);
}

}  // namespace
}  // namespace gmapping_spa
