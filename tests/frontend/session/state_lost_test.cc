// SPDX-License-Identifier: BSD-3-Clause
// Sessions of a robot that is lost.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/frontend/loop_closure/hall.h"
#include "tests/frontend/loop_closure/loop_world.h"
#include "tests/frontend/session/resumed_run.h"

namespace gmapping_spa::session {
namespace {

using backend::SE2;

// In 0.2 s and 0.2 m from scan to scan on the ring's middle line. Where it begins elsewhere than it
// ended, the robot was carried there: the wheels know nothing of it.
void Drive(double from_m, double to_m, Scans* scans) {
  const std::vector<SE2> poses = synthetic::DriveOnRing(from_m, to_m, 0.2);
  const SE2 odom_T_world =
      (scans->empty() ? SE2{} : scans->back().odom_T_robot) * Inverse(poses.front());
  for (sensor::LaserScan scan :
       synthetic::ScansAt(poses, synthetic::Hall(),
                          {.beams = 121, .field_of_view_rad = 4.5, .usable_range_m = 12.0})) {
    scan.odom_T_robot = odom_T_world * scan.odom_T_robot;
    scan.index = static_cast<std::int64_t>(scans->size());
    scan.stamp_s = 0.2 * static_cast<double>(scan.index);
    scans->push_back(scan);
  }
}

TEST(SessionOfALostRobot, GoesOnToTheSameBytesFromWhereItIsLostAndInItsNewPiece) {
  Scans scans;
  Drive(0, 46, &scans);
  const std::size_t carried = scans.size();
  Drive(70, 90, &scans);
  const auto whole = ExpectSameWhenResumed(QuickOptions(), scans,
                                           {carried + 2, carried + 4, carried + 9, carried + 60});
  EXPECT_EQ(whole->counts().pieces, 2);
}

}  // namespace
}  // namespace gmapping_spa::session
