// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/association.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gmapping_spa::metrics {
namespace {

using backend::SE2;
using backend::Trajectory;

// The x of the robot at a stamp, for trajectories along x; nothing if there is no pose.
std::optional<double> XAt(const Trajectory& trajectory, double stamp_s, double max_gap_s) {
  const auto pose = PoseAt(trajectory, stamp_s, max_gap_s);
  if (!pose) return std::nullopt;
  return pose->x;
}

TEST(SortedByStamp, KeepsTheOrderOfEqualStamps) {
  const Trajectory sorted = SortedByStamp({{2, {20, 0, 0}}, {1, {10, 0, 0}}, {2, {21, 0, 0}}});
  EXPECT_EQ(sorted[0].world_T_robot.x, 10);
  EXPECT_EQ(sorted[1].world_T_robot.x, 20);
  EXPECT_EQ(sorted[2].world_T_robot.x, 21);
}

TEST(PoseAt, AnExactStampIsTakenAsItIs) {
  const Trajectory trajectory = {
      {1, {10, 0, 0}}, {2, {20, 0, 0}}, {2, {21, 0, 0}}, {3, {30, 0, 0}}};
  EXPECT_EQ(XAt(trajectory, 1, 0), 10);
  EXPECT_EQ(XAt(trajectory, 2, 0), 20) << "the first one of equal stamps";
  EXPECT_EQ(XAt(trajectory, 3, 0), 30);
}

TEST(PoseAt, InterpolatesBetweenNeighborsIfOneIsNear) {
  const Trajectory trajectory = {{1, {10, 0, 0}}, {2, {20, 0, 0}}};
  EXPECT_NEAR(XAt(trajectory, 1.25, 0.3).value(), 12.5, 1e-12);
  EXPECT_NEAR(XAt(trajectory, 1.75, 0.3).value(), 17.5, 1e-12);
  EXPECT_EQ(XAt(trajectory, 1.5, 0.3), std::nullopt);
}

TEST(PoseAt, TheGapItselfStillCounts) {
  const Trajectory trajectory = {{1, {10, 0, 0}}, {2, {20, 0, 0}}};
  EXPECT_TRUE(PoseAt(trajectory, 1.5, 0.5).has_value());
}

TEST(PoseAt, HoldsTheEndsWithinTheGap) {
  const Trajectory trajectory = {{1, {10, 0, 0}}, {2, {20, 0, 0}}};
  EXPECT_EQ(XAt(trajectory, 0.9, 0.2), 10);
  EXPECT_EQ(XAt(trajectory, 2.1, 0.2), 20);
  EXPECT_EQ(XAt(trajectory, 0.7, 0.2), std::nullopt);
  EXPECT_EQ(XAt(trajectory, 2.3, 0.2), std::nullopt);
  EXPECT_EQ(XAt({}, 1, 100), std::nullopt);
}

TEST(PoseAt, InterpolationFollowsAnArcAndTurnsTheShortWay) {
  // A quarter of a circle of radius 1 around (0, 1), past the heading of 180 degrees.
  const double start = 0.75 * std::numbers::pi;
  const SE2 quarter = {1, 1, std::numbers::pi / 2};
  const SE2 eighth = {std::sqrt(0.5), 1 - std::sqrt(0.5), std::numbers::pi / 4};
  const SE2 from = {5, 6, start};
  const SE2 middle = PoseAt({{0, from}, {2, from * quarter}}, 1, 1).value();
  const SE2 error = backend::Between(from * eighth, middle);
  EXPECT_LT(error.translation().norm(), 1e-12);
  EXPECT_NEAR(error.theta, 0.0, 1e-12);
}

TEST(AssociateByStamp, PairsWithTheNearestWithinTheGap) {
  const Trajectory truth = {{1, {1, 0, 0}}, {2, {2, 0, 0}}, {3, {3, 0, 0}}, {4, {4, 0, 0}}};
  const Trajectory estimate = {{3.05, {30, 0, 0}}, {0.95, {10, 0, 0}}, {2.5, {25, 0, 0}}};
  const auto pairs = AssociateByStamp(truth, estimate, 0.1);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].stamp_s, 0.95);
  EXPECT_EQ(pairs[0].truth_T_robot.x, 1);
  EXPECT_EQ(pairs[0].estimate_T_robot.x, 10);
  EXPECT_EQ(pairs[1].truth_T_robot.x, 3);
  EXPECT_EQ(pairs[1].estimate_T_robot.x, 30);
}

TEST(AssociateByStamp, GoesThroughTheShorterTrajectory) {
  const Trajectory truth = {{1, {1, 0, 0}}, {2, {2, 0, 0}}};
  const Trajectory estimate = {
      {0.9, {9, 0, 0}}, {1.05, {10, 0, 0}}, {1.1, {11, 0, 0}}, {2, {20, 0, 0}}};
  const auto pairs = AssociateByStamp(truth, estimate, 0.2);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].truth_T_robot.x, 1);
  EXPECT_EQ(pairs[0].estimate_T_robot.x, 10);
  EXPECT_EQ(pairs[0].stamp_s, 1.05);
  EXPECT_EQ(pairs[1].estimate_T_robot.x, 20);
}

TEST(AssociateByStamp, TheEarlierOfTwoAsNearIsTaken) {
  const auto pairs = AssociateByStamp({{1, {1, 0, 0}}, {2, {2, 0, 0}}}, {{1.5, {0, 0, 0}}}, 1);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].truth_T_robot.x, 1);
}

TEST(AssociateByStamp, TheFirstOfEqualStampsIsTaken) {
  const auto pairs = AssociateByStamp({{1, {10, 0, 0}}, {1, {11, 0, 0}}}, {{1.1, {0, 0, 0}}}, 1);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].truth_T_robot.x, 10);
}

TEST(AssociateByStamp, GoesThroughTheEstimateIfBothAreAsLong) {
  const Trajectory truth = {{1, {1, 0, 0}}, {1.05, {2, 0, 0}}};
  const Trajectory estimate = {{1.04, {3, 0, 0}}, {5, {4, 0, 0}}};
  const auto pairs = AssociateByStamp(truth, estimate, 0.1);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].truth_T_robot.x, 2);
}

}  // namespace
}  // namespace gmapping_spa::metrics
