// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/kitti_io.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/message_of.h"

namespace gmapping_spa::backend::kitti_io_test {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<SE2> Read(const std::string& text) {
  std::istringstream in(text);
  return ReadKitti(in, "poses.txt");
}

std::string Written(const Trajectory& trajectory) {
  std::ostringstream out;
  WriteKitti(trajectory, out);
  return out.str();
}

std::string ErrorOf(const std::string& text) {
  return MessageOf([&] { Read(text); });
}

TEST(KittiIo, WritesTheMatrixRowByRow) {
  EXPECT_EQ(Written({{7.0, {1.5, -2.25, 0.0}}}), "1 0 0 1.5 0 1 0 -2.25 0 0 1 0\n");
  EXPECT_EQ(Read("0 -1 0 1.5 1 0 0 -2.25 0 0 1 8\n")[0], (SE2{1.5, -2.25, kPi / 2}));
}

TEST(KittiIo, PositionsReadBackExactlyAndAnglesToRounding) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-kPi, kPi), position(-100, 100);
  Trajectory trajectory;
  for (int k = 0; k < 1000; ++k) {
    trajectory.push_back({0.0, {position(random), position(random), angle(random)}});
  }
  const std::vector<SE2> again = Read(Written(trajectory));
  ASSERT_EQ(again.size(), trajectory.size());
  for (std::size_t k = 0; k < again.size(); ++k) {
    EXPECT_EQ(again[k].translation(), trajectory[k].world_T_robot.translation());
    EXPECT_NEAR(again[k].theta, trajectory[k].world_T_robot.theta, 1e-15);
  }
}

TEST(KittiIo, WritesTimesWithAllDigitsAndWithoutExponents) {
  std::ostringstream out;
  WriteTimes({{976052857.33753, {}}, {1e-7, {}}, {1e9, {}}}, out);
  EXPECT_EQ(out.str(), "976052857.33753\n0.0000001\n1000000000\n");
}

TEST(KittiIo, RejectsWithTheLine) {
  EXPECT_EQ(ErrorOf("# pose\n1 0 0 0 0 1 0 0 0 0 1\n"),
            "poses.txt:2: expected 12 columns (r11 r12 r13 x r21 r22 r23 y r31 r32 r33 z), found "
            "11");
  EXPECT_EQ(ErrorOf("1 0 0 nan 0 1 0 0 0 0 1 0\n"),
            "poses.txt:1: expected a finite number, found 'nan'");
  const std::string no_rotation =
      "poses.txt:1: expected a rotation matrix in columns 1-3, 5-7 and 9-11, found one that is "
      "none";
  EXPECT_EQ(ErrorOf("2 0 0 0 0 1 0 0 0 0 1 0\n"), no_rotation);
  EXPECT_EQ(ErrorOf("1 0 0 0 0 -1 0 0 0 0 1 0\n"), no_rotation) << "a reflection";
  EXPECT_EQ(ErrorOf("1e200 0 0 0 0 1 0 0 0 0 1 0\n"), no_rotation);
}

// A car that turns left by 90 degrees, about the y axis of its camera.
TEST(KittiIo, RefusesPosesOfACamera) {
  EXPECT_EQ(ErrorOf("1 0 0 0 0 1 0 0 0 0 1 0\n0 0 -1 3 0 1 0 0 1 0 0 9\n"),
            "poses.txt:2: expected a z axis that points up (a robot in the plane, not a camera), "
            "found one whose vertical part is 0.000");
}

TEST(KittiIo, DoesNotWriteWhatItWouldNotRead) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::ostringstream out;
  EXPECT_THROW(Written({{0.0, {nan, 0, 0}}}), std::invalid_argument);
  EXPECT_THROW(WriteTimes({{nan, {}}}, out), std::invalid_argument);
}

}  // namespace
}  // namespace gmapping_spa::backend::kitti_io_test
