// SPDX-License-Identifier: BSD-3-Clause
// What takes in the readings of a simulated robot: a log, or a mapper.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_LOG_SINK_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_LOG_SINK_H_

#include <cmath>
#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"
#include "experiments/simulation/lidar.h"

namespace gmapping_spa::simulation {

struct OdometryReading {
  double stamp_s = 0.0;
  backend::SE2 odom_T_robot;
  BodyVelocity velocity;
};

// Rounded as a log holds it.
inline double LoggedNumber(double value) { return std::round(value * 1e6) / 1e6; }
inline backend::SE2 LoggedPose(const backend::SE2& pose) {
  return {LoggedNumber(pose.x), LoggedNumber(pose.y), LoggedNumber(pose.theta)};
}

// Readings come in the order of time, rounded to what a log holds: a millimetre for ranges, 1e-6
// for all else. So a mapper that is fed directly gets the same as one that reads the log.
class LogSink {
 public:
  virtual ~LogSink() = default;

  virtual void OnOdometry(const OdometryReading& reading) = 0;

  // With the odometry at the scan's stamp.
  virtual void OnScan(const OdometryReading& odometry, const LidarOptions& lidar,
                      const std::vector<double>& ranges_m) = 0;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_LOG_SINK_H_
