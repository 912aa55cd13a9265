// SPDX-License-Identifier: BSD-3-Clause
// Beams that end on the robot itself.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_ROBOT_BEAM_FILTER_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_ROBOT_BEAM_FILTER_H_

#include "frontend/sensor/beam_filter.h"

namespace gmapping_spa::sensor {

// Posts, bumpers and cables go along with the robot: their beams are short and stay as they are
// while the robot turns and most others change. Such beams become kInvalid. A wall that the robot
// drives along looks alike for a while; that is why the odometry must have turned.
class RobotBeamFilter : public BeamFilter {
 public:
  void Learn(const std::vector<const LaserScan*>& scans) override;
  std::int64_t Apply(LaserScan* scan) const override;
  const char* count_name() const override { return "beams_on_robot"; }

 private:
  struct BeamRecord {
    double usual_m = 0.0;        // median of the first scans; 0 where it is no short hit
    std::int64_t num_alike = 0;  // tests in which it was that long
  };

  // Takes the scans' usual ranges for those to test.
  void Begin(const std::vector<const LaserScan*>& scans);
  void Test(const LaserScan& scan);
  bool IsOnRobot(const BeamRecord& beam) const;

  std::vector<BeamRecord> beams_;  // of scans with this number of beams; others are left alone
  std::vector<double> usual_m_;    // of all beams, to tell scans in which most have changed
  std::int64_t num_tests_ = 0;
  double least_heading_rad_ = 0.0, greatest_heading_rad_ = 0.0;  // of the tests, by the odometry
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_ROBOT_BEAM_FILTER_H_
