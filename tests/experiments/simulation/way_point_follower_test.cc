// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/way_point_follower.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gmapping_spa::simulation::way_point_follower_test {
namespace {

using testing::HasSubstr;

constexpr double kStepS = 0.05;

double DistanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                         const Eigen::Vector2d& to) {
  const double share = (point - from).dot(to - from) / (to - from).squaredNorm();
  return (point - from - std::clamp(share, 0.0, 1.0) * (to - from)).norm();
}

TEST(WayPointFollower, StaysNearTheLineAndWithinItsLimits) {
  // Right angles, a slight bend, an acute angle and the way back.
  const WayPoints way_points = {{0, 0}, {6, 0}, {6, 5}, {12, 6}, {9, 4}, {9, 9}, {9, 4}};
  const WayPointFollowerOptions options;
  WayPointFollower follower(way_points, options);
  backend::SE2 pose = follower.Start();
  BodyVelocity last;
  double farthest_m = 0.0, top_speed_m_s = 0.0;
  int steps = 0;
  for (; !follower.Done() && steps < 4000; ++steps) {
    const BodyVelocity velocity = follower.Next(pose, kStepS);
    if (follower.Done()) break;
    EXPECT_LE(std::abs(velocity.linear_m_s), options.max_speed_m_s + 1e-9);
    EXPECT_LE(std::abs(velocity.angular_rad_s), options.max_turn_rate_rad_s + 1e-9);
    EXPECT_LE(std::abs(velocity.linear_m_s - last.linear_m_s),
              options.max_acceleration_m_s2 * kStepS + 1e-9);
    EXPECT_LE(std::abs(velocity.angular_rad_s - last.angular_rad_s),
              options.max_angular_acceleration_rad_s2 * kStepS + 1e-9);
    last = velocity;
    pose = Drive(pose, velocity, kStepS);
    double distance_m = 1e9;
    for (std::size_t i = 1; i < way_points.size(); ++i) {
      distance_m = std::min(
          distance_m, DistanceToSegment(pose.translation(), way_points[i - 1], way_points[i]));
    }
    farthest_m = std::max(farthest_m, distance_m);
    top_speed_m_s = std::max(top_speed_m_s, velocity.linear_m_s);
  }
  EXPECT_TRUE(follower.Done());
  EXPECT_LT(farthest_m, 0.3);
  EXPECT_GT(top_speed_m_s, 1.4);
  EXPECT_LT((pose.translation() - way_points.back()).norm(), 0.3);
}

TEST(WayPointFollower, StartsAtTheFirstPointFacingTheSecond) {
  const backend::SE2 start = WayPointFollower({{1, 2}, {1, 5}}, {}).Start();
  EXPECT_EQ(start.x, 1.0);
  EXPECT_EQ(start.y, 2.0);
  EXPECT_NEAR(start.theta, std::atan2(1.0, 0.0), 1e-12);
}

// Where the robot is at each step, and its velocity from there on.
std::vector<std::pair<backend::SE2, BodyVelocity>> DriveAll(
    const WayPoints& way_points, const WayPointFollowerOptions& options) {
  std::vector<std::pair<backend::SE2, BodyVelocity>> steps;
  WayPointFollower follower(way_points, options);
  backend::SE2 pose = follower.Start();
  while (!follower.Done() && steps.size() < 10000) {
    const BodyVelocity velocity = follower.Next(pose, kStepS);
    steps.emplace_back(pose, velocity);
    pose = Drive(pose, velocity, kStepS);
  }
  EXPECT_TRUE(follower.Done());
  return steps;
}

TEST(WayPointFollower, ReversesTheSameWayWithItsRearFirst) {
  const WayPoints way_points = {{0, 0}, {6, 0}, {6, 5}};
  WayPointFollowerOptions options;
  const auto forwards = DriveAll(way_points, options);
  options.reverse = true;
  const auto backwards = DriveAll(way_points, options);
  ASSERT_EQ(backwards.size(), forwards.size());
  for (std::size_t i = 0; i < forwards.size(); ++i) {
    const auto& [pose, velocity] = forwards[i];
    const auto& [reversed_pose, reversed_velocity] = backwards[i];
    EXPECT_NEAR((reversed_pose.translation() - pose.translation()).norm(), 0.0, 1e-9);
    EXPECT_NEAR(std::abs(backend::WrapAngle(reversed_pose.theta - pose.theta)), std::numbers::pi,
                1e-9);
    EXPECT_NEAR(reversed_velocity.linear_m_s, -velocity.linear_m_s, 1e-9);
    EXPECT_NEAR(reversed_velocity.angular_rad_s, velocity.angular_rad_s, 1e-9);
  }
}

TEST(WayPointFollower, TurnsOnTheSpotAtWayPoints) {
  for (const double turns : {2.0, -1.0}) {
    WayPointFollowerOptions options;
    options.turns_at_way_points = turns;
    double turned_rad = 0.0, farthest_m = 0.0;
    for (const auto& [pose, velocity] : DriveAll({{0, 0}, {4, 0}, {8, 0}}, options)) {
      EXPECT_LE(std::abs(velocity.angular_rad_s), options.max_turn_rate_rad_s + 1e-9);
      turned_rad += velocity.angular_rad_s * kStepS;
      if (std::abs(velocity.angular_rad_s) > 0.2) {
        farthest_m = std::max(farthest_m, std::min(std::abs(pose.x - 4.0), std::abs(pose.x - 8.0)));
      }
    }
    EXPECT_NEAR(turned_rad, 2.0 * turns * 2.0 * std::numbers::pi, 0.01);
    EXPECT_LT(farthest_m, 0.3);
  }
}

std::string ErrorOf(const std::string& yaml) {
  const std::string path = testing::TempDir() + "way_points.yaml";
  std::ofstream(path) << yaml;
  try {
    ReadTours(path);
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).substr(path.size());
  }
  return "no error";
}

TEST(ReadTours, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(ErrorOf("way_points: [[0, 0], [1, 0]]\n"), "no error");
  EXPECT_EQ(ErrorOf("way_points:\n  - [0, 0]\n  - [1]\n"),
            ":3: expected a way point [x, y], found a list of 1");
  EXPECT_THAT(ErrorOf("way_points:\n  - [1, 2]\n  - [1, 2]\n"), HasSubstr(":3: "));
  EXPECT_THAT(ErrorOf("way_points: [[0, 0]]\n"), HasSubstr("two or more way points, found 1"));
  EXPECT_THAT(ErrorOf("points: [[0, 0], [1, 0]]\n"), HasSubstr("found 'points'"));
  EXPECT_THAT(ErrorOf("way_points: [[0, 0], [1, 0]]\ncarried_to: [3]\n"), HasSubstr("a list of"));
  EXPECT_THAT(ErrorOf("way_points: 3\n"), HasSubstr("expected a list for 'way_points'"));
}

TEST(ReadTours, ReadsWhereTheRobotIsCarriedTo) {
  const std::string path = testing::TempDir() + "tours.yaml";
  std::ofstream(path) << "way_points: [[0, 0], [1, 0]]\n"
                         "carried_to:\n  - [[5, 0], [6, 0]]\n  - [[7, 1], [8, 1], [9, 1]]\n";
  const std::vector<WayPoints> tours = ReadTours(path);
  ASSERT_EQ(tours.size(), 3u);
  EXPECT_EQ(tours[0], (WayPoints{{0, 0}, {1, 0}}));
  EXPECT_EQ(tours[2], (WayPoints{{7, 1}, {8, 1}, {9, 1}}));
}

}  // namespace
}  // namespace gmapping_spa::simulation::way_point_follower_test
