#include "experiments/simulation/carmen_writer.h"

#include <gtest/gtest.h>

#include <sstream>

namespace gmapping_spa::simulation {
namespace {

TEST(CarmenWriter, WritesEachRecordAsOneLine) {
  std::ostringstream out;
  out.precision(1);  // The stream's settings must not matter.
  CarmenWriter writer(out);
  writer.WriteComment("made up");
  writer.WriteOdometry(0.05, {1.5, -2.0, 0.25}, {1.0, -0.5});
  LidarOptions lidar;
  lidar.beams = 4;
  lidar.range_noise_m = 0.02;
  writer.WriteScan(12.1, {1.5, -2.0, 0.25}, {1.0, -0.5}, lidar, {1.0, 2.3456, 30.0, 0.5});
  EXPECT_EQ(
      out.str(),
      "# made up\n"
      "ODOM 1.500000 -2.000000 0.250000 1.000000 -0.500000 0 0.050000 simulator 0.050000\n"
      "ROBOTLASER1 0 -3.141592654 4.712388980 1.570796327 30.000 0.020 0 4 1.000 2.346 30.000 "
      "0.500 0 1.500000 -2.000000 0.250000 1.500000 -2.000000 0.250000 1.000000 -0.500000 "
      "0 0 0 12.100000 simulator 12.100000\n");
}

}  // namespace
}  // namespace gmapping_spa::simulation
