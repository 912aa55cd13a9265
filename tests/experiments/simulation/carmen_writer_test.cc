// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/carmen_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace gmapping_spa::simulation {
namespace {

TEST(CarmenWriter, WritesEachRecordAsOneLine) {
  std::ostringstream out;
  out.precision(1);  // The stream's settings must not matter.
  CarmenWriter writer(out);
  const std::size_t header = out.str().size();
  writer.OnOdometry({0.05, {1.5, -2.0, 0.25}, {1.0, -0.5}});
  LidarOptions lidar;
  lidar.beams = 4;
  writer.OnScan({12.1, {1.5, -20.000001, 0.25}, {1.0, -0.5}}, lidar, {1.0, 2.3456, 30.0, 0.07});
  EXPECT_EQ(
      out.str().substr(header),
      "ODOM 1.500000 -2.000000 0.250000 1.000000 -0.500000 0 0.050000 simulator 0.050000\n"
      "ROBOTLASER1 0 -3.141592653589793 4.71238898038469 1.5707963267948966 30 0.015 0 4 1.000 "
      "2.346 30.000 0.070 0 1.500000 -20.000001 0.250000 1.500000 -20.000001 0.250000 1.000000 "
      "-0.500000 0 0 0 12.100000 simulator 12.100000\n");
}

TEST(CarmenWriter, WritesFieldOfViewAndMountOfTheLaser) {
  std::ostringstream out;
  CarmenWriter writer(out);
  const std::size_t header = out.str().size();
  LidarOptions lidar;
  lidar.beams = 3;
  lidar.fov_rad = 1.5;
  lidar.fov_center_rad = 0.25;
  lidar.robot_T_laser = {0.5, 0.0, 1.0};
  // A quarter turn to the left: the laser is half a metre above the robot.
  writer.OnScan({1.0, {2.0, 3.0, std::acos(0.0)}, {}}, lidar, {1.0, 1.0, 1.0});
  EXPECT_EQ(out.str().substr(header),
            "ROBOTLASER1 0 -0.5 1.5 0.75 30 0.015 0 3 1.000 1.000 1.000 0 2.000000 3.500000 "
            "2.570796 2.000000 3.000000 1.570796 0.000000 0.000000 0 0 0 1.000000 simulator "
            "1.000000\n");
}

TEST(CarmenWriter, BeginsWithComments) {
  std::ostringstream out;
  CarmenWriter writer(out);
  std::istringstream lines(out.str());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_EQ(line[0], '#') << line;
  EXPECT_EQ(count, 3);
}

}  // namespace
}  // namespace gmapping_spa::simulation
