// SPDX-License-Identifier: BSD-3-Clause
// A simulated robot's scans for a mapper in the same process.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_SCAN_PLAYER_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_SCAN_PLAYER_H_

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "experiments/simulation/log_sink.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::simulation {

// Hands on the scans that sensor::OpenCarmenLog would read from the log of the same readings with
// its default options; the laser's mounting is exact here, and there a mean of rounded poses, less
// than 1 um off.
class ScanPlayer : public LogSink {
 public:
  explicit ScanPlayer(std::function<void(const sensor::LaserScan&)> play)
      : play_(std::move(play)) {}

  void OnOdometry(const OdometryReading& /*reading*/) override {}
  void OnScan(const OdometryReading& odometry, const LidarOptions& lidar,
              const std::vector<double>& ranges_m) override;

 private:
  std::function<void(const sensor::LaserScan&)> play_;
  std::int64_t num_scans_ = 0;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_SCAN_PLAYER_H_
