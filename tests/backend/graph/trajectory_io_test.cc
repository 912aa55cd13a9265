// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/trajectory_io.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>

#include "tests/message_of.h"

namespace gmapping_spa::backend::trajectory_io_test {
namespace {

constexpr double kPi = std::numbers::pi;

Trajectory Read(const std::string& text) {
  std::istringstream in(text);
  return ReadTum(in, "poses.tum");
}

std::string Written(const Trajectory& trajectory) {
  std::ostringstream out;
  WriteTum(trajectory, out);
  return out.str();
}

std::string ErrorOf(const std::string& text) {
  return MessageOf([&] { Read(text); });
}

void ExpectReadsBackExactly(const Trajectory& trajectory) {
  const Trajectory again = Read(Written(trajectory));
  ASSERT_EQ(again.size(), trajectory.size());
  for (std::size_t k = 0; k < trajectory.size(); ++k) {
    EXPECT_EQ(again[k].stamp_s, trajectory[k].stamp_s) << k;
    EXPECT_EQ(again[k].world_T_robot, trajectory[k].world_T_robot) << k;
  }
}

TEST(TrajectoryIo, WritesOnePlainLineAPose) {
  EXPECT_EQ(Written({{976052857.33753, {1.5, -2.25, 0.0}}, {1e9, {0, 1e-3, kPi}}}),
            "976052857.33753 1.5 -2.25 0 0 0 0 1\n"
            "1000000000 0 0.001 0 0 0 1 6.123233995736766e-17\n");
}

TEST(TrajectoryIo, RandomPosesAndStampsReadBackExactly) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-kPi, kPi), position(-100, 100), stamp(0, 2e9);
  Trajectory trajectory;
  for (int k = 0; k < 20000; ++k) {
    trajectory.push_back({stamp(random), {position(random), position(random), angle(random)}});
  }
  ExpectReadsBackExactly(trajectory);
}

TEST(TrajectoryIo, SpecialAnglesAndMagnitudesReadBackExactly) {
  Trajectory trajectory;
  for (const double theta : {0.0, kPi, -kPi, kPi / 2, -kPi / 2, kPi / 3, 1e-300, 1e-9, -1e-17,
                             std::nextafter(kPi, 0.0), std::nextafter(kPi / 2, 0.0)}) {
    trajectory.push_back({0.1, {1.0 / 3.0, 1e-12, theta}});
  }
  const double denormal = std::numeric_limits<double>::denorm_min();
  const double max = std::numeric_limits<double>::max();
  trajectory.push_back({denormal, {denormal, -max, 0.0}});
  trajectory.push_back({-max, {0.0, 0.0, 0.0}});
  ExpectReadsBackExactly(trajectory);
}

TEST(TrajectoryIo, ReadsInFileOrderWithStampsThatGoBackward) {
  const Trajectory trajectory = Read("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n");
  ASSERT_EQ(trajectory.size(), 3u);
  EXPECT_EQ(trajectory[0].stamp_s, 2.0);
  EXPECT_EQ(trajectory[1].stamp_s, 1.0);
  EXPECT_EQ(trajectory[2].stamp_s, 2.0);
}

TEST(TrajectoryIo, NothingInTheFileIsAnEmptyTrajectory) {
  EXPECT_TRUE(Read("").empty());
  EXPECT_TRUE(Read("# stamp x y z qx qy qz qw\n").empty());
  EXPECT_EQ(Written({}), "");
}

TEST(TrajectoryIo, BothSignsOfAQuaternionAreTheSameYaw) {
  const Trajectory trajectory = Read("0 0 0 0 0 0 0.6 0.8\n0 0 0 0 0 0 -0.6 -0.8\n");
  EXPECT_NEAR(trajectory[0].world_T_robot.theta, 2 * std::atan2(0.6, 0.8), 1e-15);
  EXPECT_NEAR(trajectory[1].world_T_robot.theta, 2 * std::atan2(0.6, 0.8), 1e-15);
}

TEST(TrajectoryIo, TakesTheYawOfATiltedRotation) {
  // Rotation about z by 0.7, after y by -0.2, after x by 0.3.
  const Eigen::Quaterniond q = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
  std::ostringstream line;
  line.precision(17);
  line << "5 1 2 3 " << q.x() << ' ' << q.y() << ' ' << q.z() << ' ' << q.w();
  const Trajectory trajectory = Read(line.str());
  EXPECT_EQ(trajectory[0].world_T_robot.x, 1.0);
  EXPECT_EQ(trajectory[0].world_T_robot.y, 2.0);
  EXPECT_NEAR(trajectory[0].world_T_robot.theta, 0.7, 1e-12);
}

TEST(TrajectoryIo, AcceptsQuaternionsRoundedToThreeDigits) {
  EXPECT_NEAR(Read("0 0 0 0 0 0 0.479 0.878")[0].world_T_robot.theta, 1.0, 2e-3);
}

TEST(TrajectoryIo, RejectsWithTheLine) {
  EXPECT_EQ(ErrorOf("0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 0\n"),
            "poses.tum:2: expected a quaternion of norm 1, found one of norm 0.000000");
  EXPECT_EQ(ErrorOf("0 0 0 0 1 0 0 1\n"),
            "poses.tum:1: expected a quaternion of norm 1, found one of norm 1.414214");
  EXPECT_EQ(ErrorOf("# t\n0 1 2 3\n"),
            "poses.tum:2: expected 8 columns (stamp x y z qx qy qz qw), found 4");
  EXPECT_EQ(ErrorOf("0 nan 0 0 0 0 0 1\n"), "poses.tum:1: expected a finite number, found 'nan'");
  EXPECT_NE(ErrorOf("0 0 0 0 1e200 0 0 1\n"), "no error");
}

TEST(TrajectoryIo, DoesNotWriteWhatItWouldNotRead) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Written({{0.0, {nan, 0, 0}}}), std::invalid_argument);
  EXPECT_THROW(Written({{nan, {0, 0, 0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace gmapping_spa::backend::trajectory_io_test
