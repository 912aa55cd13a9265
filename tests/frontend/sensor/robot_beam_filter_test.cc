// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/robot_beam_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace gmapping_spa::sensor {
namespace {

constexpr int kBeams = 180;

// Distance from (x, y) along an angle to the walls of a room of 8 x 6 m around the origin.
double RangeInRoom(double x, double y, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const double to_x = ((c > 0 ? 4.0 : -4.0) - x) / c, to_y = ((s > 0 ? 3.0 : -3.0) - y) / s;
  return std::min(to_x, to_y);
}

// A robot on a circle of 1.5 m, whose beams from `first` to `last` end at a post 0.4 m away.
std::vector<LaserScan> Drive(int count, int first, int last, double turn_per_scan_rad = 0.05) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise_m(0.0, 0.008);
  std::vector<LaserScan> scans(count);
  for (int i = 0; i < count; ++i) {
    const double heading_rad = turn_per_scan_rad * i;
    const double x = 1.5 * std::sin(heading_rad), y = -1.5 * std::cos(heading_rad);
    scans[i].odom_T_robot = {x, y, backend::WrapAngle(heading_rad)};
    for (int k = 0; k < kBeams; ++k) {
      const double angle_rad = std::numbers::pi * (k / 180.0 - 0.5);
      const bool on_post = k >= first && k <= last;
      const double range_m = on_post ? 0.4 : RangeInRoom(x, y, heading_rad + angle_rad);
      scans[i].beams.push_back({angle_rad, range_m + noise_m(random), BeamStatus::kHit});
    }
  }
  return scans;
}

RobotBeamFilter Learned(const std::vector<LaserScan>& scans) {
  std::vector<const LaserScan*> pointers;
  for (const LaserScan& scan : scans) pointers.push_back(&scan);
  RobotBeamFilter filter;
  filter.Learn(pointers);
  return filter;
}

TEST(RobotBeamFilter, LeavesOutBeamsThatStayAsTheyAreWhileTheRobotTurns) {
  for (const auto& [first, last] : {std::pair(0, 9), std::pair(85, 95), std::pair(100, 171)}) {
    std::vector<LaserScan> scans = Drive(200, first, last);
    const RobotBeamFilter filter = Learned(scans);
    for (LaserScan& scan : scans) {
      EXPECT_EQ(filter.Apply(&scan), last - first + 1);
      for (int k = 0; k < kBeams; ++k) {
        EXPECT_EQ(scan.beams[k].status,
                  k >= first && k <= last ? BeamStatus::kInvalid : BeamStatus::kHit);
      }
    }
  }
}

TEST(RobotBeamFilter, LeavesARobotWithoutPartsInViewAlone) {
  std::vector<LaserScan> scans = Drive(200, -1, -1);
  const RobotBeamFilter filter = Learned(scans);
  for (LaserScan& scan : scans) EXPECT_EQ(filter.Apply(&scan), 0);
}

TEST(RobotBeamFilter, ConcludesNothingFromARobotThatStands) {
  std::vector<LaserScan> scans = Drive(200, 0, 9, 0.0);
  EXPECT_EQ(Learned(scans).Apply(&scans[0]), 0);
}

// The wall at its side stays where it is, and all else changes.
TEST(RobotBeamFilter, TakesNoWallForThatTheRobotFollowsStraightOn) {
  std::vector<LaserScan> scans(200);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> other_m(2.0, 9.0);
  for (LaserScan& scan : scans) {
    for (int k = 0; k < kBeams; ++k) {
      scan.beams.push_back({0.01 * k, k < 40 ? 0.5 : other_m(random), BeamStatus::kHit});
    }
  }
  EXPECT_EQ(Learned(scans).Apply(&scans[0]), 0);
}

TEST(RobotBeamFilter, LeavesScansWithAnotherNumberOfBeamsAlone) {
  const RobotBeamFilter filter = Learned(Drive(200, 0, 9));
  LaserScan other;
  other.beams.assign(90, {0.0, 0.4, BeamStatus::kHit});
  EXPECT_EQ(filter.Apply(&other), 0);
}

}  // namespace
}  // namespace gmapping_spa::sensor
