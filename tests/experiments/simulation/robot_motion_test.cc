// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/robot_motion.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace gmapping_spa::simulation {
namespace {

constexpr double kStepsPerS = 20.0;

TEST(DriveTours, EachStepLeadsToTheNext) {
  const std::vector<MotionStep> steps = DriveTours({{{1, 2}, {5, 2}, {5, 6}}}, {}, kStepsPerS, 1.0);
  EXPECT_EQ(steps.front().world_T_robot, (backend::SE2{1.0, 2.0, 0.0}));
  EXPECT_LT((steps.back().world_T_robot.translation() - Eigen::Vector2d(5, 6)).norm(), 0.3);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    EXPECT_EQ(steps[i].time_s, static_cast<double>(i) / kStepsPerS);
    EXPECT_EQ(steps[i + 1].world_T_robot,
              Drive(steps[i].world_T_robot, steps[i].after, 1.0 / kStepsPerS));
    EXPECT_EQ(steps[i + 1].before.linear_m_s, steps[i].after.linear_m_s);
    EXPECT_FALSE(steps[i].carried);
  }
}

TEST(DriveTours, BetweenTwoToursTheRobotIsCarried) {
  const std::vector<MotionStep> steps =
      DriveTours({{{1, 2}, {3, 2}}, {{9, 9}, {9, 7}}}, {}, kStepsPerS, 1.5);
  std::size_t carried = 0, begin = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].time_s, static_cast<double>(i) / kStepsPerS);
    if (!steps[i].carried) continue;
    if (carried++ == 0) begin = i;
    EXPECT_EQ(steps[i].after.linear_m_s, 0.0);
  }
  EXPECT_EQ(carried, 30u);
  EXPECT_LT(steps[begin - 1].world_T_robot.x, 3.1);
  EXPECT_EQ(steps[begin + carried].world_T_robot.translation(), Eigen::Vector2d(9, 9));
}

TEST(DriveTours, FailsWhereTheRobotCannotArrive) {
  WayPointFollowerOptions options;
  options.max_acceleration_m_s2 = 0.0;
  EXPECT_THROW(DriveTours({{{1, 2}, {3, 2}}}, options, kStepsPerS, 1.0), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::simulation
