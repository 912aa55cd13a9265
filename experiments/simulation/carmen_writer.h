// SPDX-License-Identifier: BSD-3-Clause
// Sensor logs as CARMEN text, one record a line
// (http://carmen.sourceforge.net/logger_playback.html).
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_CARMEN_WRITER_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_CARMEN_WRITER_H_

#include <ostream>
#include <vector>

#include "experiments/simulation/log_sink.h"

namespace gmapping_spa::simulation {

// Both time stamps of a record are the time of measurement.
class CarmenWriter : public LogSink {
 public:
  // Writes comments that say what the records hold.
  explicit CarmenWriter(std::ostream& out);

  // ODOM
  void OnOdometry(const OdometryReading& reading) override;
  // ROBOTLASER1
  void OnScan(const OdometryReading& odometry, const LidarOptions& lidar,
              const std::vector<double>& ranges_m) override;

 private:
  std::ostream& out_;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_CARMEN_WRITER_H_
