// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/lidar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/experiments/simulation/room.h"

namespace gmapping_spa::simulation::lidar_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

LidarOptions OneDegreeBeams() {
  LidarOptions options;
  options.beams = 360;
  return options;
}

TEST(Lidar, BeamsGoRoundFromBehindInTheLaserFrame) {
  LidarOptions options;
  options.beams = 4;
  options.range_noise_m = 0.0;
  // Facing up: behind is the lower wall, then right, front and left.
  const std::vector<double> ranges_m =
      Scan(Room(), {0.0, {3.0, 2.0, std::acos(0.0)}, {}, {}}, options, 1, 0);
  ASSERT_EQ(ranges_m.size(), 4u);
  EXPECT_NEAR(ranges_m[0], 1.9, 1e-9);
  EXPECT_NEAR(ranges_m[1], 4.9, 1e-9);
  EXPECT_NEAR(ranges_m[2], 3.9, 1e-9);
  EXPECT_NEAR(ranges_m[3], 2.9, 1e-9);
}

TEST(Lidar, APartialFieldOfViewHasABeamAtEachEnd) {
  LidarOptions options;
  options.range_noise_m = 0.0;
  options.beams = 3;
  options.fov_rad = std::numbers::pi;
  EXPECT_DOUBLE_EQ(options.start_angle_rad(), -std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(options.angular_resolution_rad(), std::numbers::pi / 2.0);
  // Facing up: right, front and left.
  const Sweep sweep{0.0, {3.0, 2.0, std::numbers::pi / 2.0}, {}, {}};
  EXPECT_THAT(Scan(Room(), sweep, options, 1, 0),
              ElementsAre(DoubleNear(4.9, 1e-9), DoubleNear(3.9, 1e-9), DoubleNear(2.9, 1e-9)));
  // A field of view round the left side: front, left and back.
  options.fov_center_rad = std::numbers::pi / 2.0;
  EXPECT_THAT(Scan(Room(), sweep, options, 1, 0),
              ElementsAre(DoubleNear(3.9, 1e-9), DoubleNear(2.9, 1e-9), DoubleNear(1.9, 1e-9)));
}

TEST(Lidar, SeesFromWhereItIsMounted) {
  LidarOptions options;
  options.range_noise_m = 0.0;
  options.beams = 4;
  // Half a metre before the robot's middle, and looking to the rear.
  options.robot_T_laser = {0.5, 0.0, std::numbers::pi};
  const Sweep sweep{0.0, {3.0, 2.0, 0.0}, {}, {}};
  EXPECT_THAT(Scan(Room(), sweep, options, 1, 0),
              ElementsAre(DoubleNear(4.4, 1e-9), DoubleNear(3.9, 1e-9), DoubleNear(3.4, 1e-9),
                          DoubleNear(1.9, 1e-9)));
}

TEST(Lidar, IsCarriedRoundByTheTurningRobot) {
  LidarOptions options;
  options.range_noise_m = 0.0;
  options.beams = 4;
  options.motion_during_scan = true;
  options.robot_T_laser = {0.5, 0.0, 0.0};
  // A quarter turn in half a turn of the laser: the first beam, to the rear of a laser that is at
  // (3, 1.5) and faces down, goes up to the wall at y = 5.9.
  const Sweep sweep{0.0, {3.0, 2.0, 0.0}, {0.0, std::numbers::pi / 2.0 / 0.05}, {}};
  EXPECT_NEAR(Scan(Room(), sweep, options, 1, 0)[0], 4.4, 1e-9);
}

TEST(Lidar, NoiseIsNormalWithTheGivenDeviation) {
  LidarOptions options = OneDegreeBeams();
  options.range_noise_m = 0.03;
  LidarOptions exact = options;
  exact.range_noise_m = 0.0;
  const World room = Room();
  const backend::SE2 pose{3.0, 2.0, 0.3};
  const std::vector<double> true_ranges_m = Scan(room, {0.0, pose, {}, {}}, exact, 5, 0);
  double sum = 0.0, sum_squares = 0.0;
  constexpr int kScans = 200;
  for (int scan = 0; scan < kScans; ++scan) {
    const std::vector<double> ranges_m = Scan(room, {0.0, pose, {}, {}}, options, 5, scan);
    for (int beam = 0; beam < options.beams; ++beam) {
      const double error_m = ranges_m[beam] - true_ranges_m[beam];
      sum += error_m;
      sum_squares += error_m * error_m;
    }
  }
  const double count = kScans * options.beams;
  // Five standard errors.
  EXPECT_NEAR(sum / count, 0.0, 5.0 * 0.03 / std::sqrt(count));
  EXPECT_NEAR(sum_squares / count, 9e-4, 5.0 * 9e-4 * std::sqrt(2.0 / count));
}

TEST(Lidar, NoReturnIsTheMaximumRange) {
  LidarOptions options = OneDegreeBeams();
  options.max_range_m = 3.5;
  const std::vector<double> ranges_m = Scan(Room(), {0.0, {3.0, 2.0, 0.0}, {}, {}}, options, 1, 0);
  EXPECT_EQ(ranges_m[180], 3.5);  // Ahead the wall is 4.9 m away.
  EXPECT_NEAR(ranges_m[0], 2.9, 0.1);
  EXPECT_LE(*std::max_element(ranges_m.begin(), ranges_m.end()), 3.5);
}

TEST(Lidar, SeesThePedestrianWhereItIsAtThatTime) {
  LidarOptions options;
  options.beams = 4;
  options.range_noise_m = 0.0;
  // Walks up the room to the right of the robot.
  const Scene scene(Room(), Pedestrian{{0.2, 0.4}, 1.0, {{5.0, 1.0}, {5.0, 5.0}}});
  const auto ahead_m = [&](double time_s) {
    return Scan(scene, {time_s, {3.0, 2.0, 0.0}, {}, {}}, options, 1, 0)[2];
  };
  EXPECT_NEAR(ahead_m(0.0), 4.9, 1e-9);
  EXPECT_NEAR(ahead_m(0.89), 4.9, 1e-9);  // not there before its front, 0.1 m ahead of its center
  EXPECT_NEAR(ahead_m(0.91), 1.8, 1e-9);
  EXPECT_NEAR(ahead_m(1.09), 1.8, 1e-9);
  EXPECT_NEAR(ahead_m(1.11), 4.9, 1e-9);
  EXPECT_NEAR(ahead_m(7.0), 1.8, 1e-9);  // on its way back
}

LidarOptions FourMovingBeams() {
  LidarOptions options;
  options.beams = 4;
  options.range_noise_m = 0.0;
  options.motion_during_scan = true;
  return options;
}

TEST(Lidar, MeasuresEachBeamFromWhereTheLaserIsAtItsTime) {
  // Brakes from 2 m/s to 1 m/s in the middle of a turn of 0.1 s, at x = 3 m.
  const Sweep sweep{0.0, {3.0, 2.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}};
  const std::vector<double> ranges_m = Scan(Room(), sweep, FourMovingBeams(), 1, 0);
  EXPECT_NEAR(ranges_m[0], 2.9 - 2.0 * 0.05, 1e-9);  // behind, half a turn earlier
  EXPECT_NEAR(ranges_m[2], 4.9, 1e-9);               // ahead, at the stamp
  const Sweep upwards{0.0, {3.0, 2.0, std::acos(0.0)}, {2.0, 0.0}, {1.0, 0.0}};
  const std::vector<double> turned_m = Scan(Room(), upwards, FourMovingBeams(), 1, 0);
  EXPECT_NEAR(turned_m[0], 1.9 - 2.0 * 0.05, 1e-9);
  EXPECT_NEAR(turned_m[2], 3.9, 1e-9);
  // The same when nothing moves.
  LidarOptions at_once = FourMovingBeams();
  at_once.motion_during_scan = false;
  const Sweep still{0.0, {3.0, 2.0, 0.3}, {}, {}};
  EXPECT_EQ(Scan(Room(), still, FourMovingBeams(), 1, 0), Scan(Room(), still, at_once, 1, 0));
}

TEST(Lidar, TurnsWithTheRobotDuringAScan) {
  LidarOptions options = FourMovingBeams();
  // Half a turn of the robot in half a turn of the laser: the beam from behind is measured ahead.
  const double turn_rate_rad_s = std::numbers::pi / 0.05;
  const Sweep sweep{0.0, {3.0, 2.0, 0.0}, {0.0, turn_rate_rad_s}, {}};
  EXPECT_NEAR(Scan(Room(), sweep, options, 1, 0)[0], 4.9, 1e-9);
}

TEST(Lidar, SeesThePedestrianMoveDuringAScan) {
  LidarOptions options = FourMovingBeams();
  options.rate_hz = 1.0;
  const Scene scene(Room(), Pedestrian{{0.2, 0.4}, 1.0, {{1.0, 1.0}, {1.0, 5.0}}});
  // Behind the robot 1 s after the start; the beam that points there is half a second early.
  const auto behind_m = [&](double stamp_s) {
    return Scan(scene, {stamp_s, {3.0, 2.0, 0.0}, {}, {}}, options, 1, 0)[0];
  };
  EXPECT_NEAR(behind_m(1.0), 2.9, 1e-9);
  EXPECT_NEAR(behind_m(1.5), 1.8, 1e-9);
}

TEST(Lidar, ScansDifferByNumberAndSeedOnly) {
  const World room = Room();
  const LidarOptions options = OneDegreeBeams();
  const backend::SE2 pose{3.0, 2.0, 0.0};
  EXPECT_EQ(Scan(room, {0.0, pose, {}, {}}, options, 1, 7),
            Scan(room, {0.0, pose, {}, {}}, options, 1, 7));
  EXPECT_NE(Scan(room, {0.0, pose, {}, {}}, options, 1, 7),
            Scan(room, {0.0, pose, {}, {}}, options, 1, 8));
  EXPECT_NE(Scan(room, {0.0, pose, {}, {}}, options, 1, 7),
            Scan(room, {0.0, pose, {}, {}}, options, 2, 7));
}

}  // namespace
}  // namespace gmapping_spa::simulation::lidar_test
