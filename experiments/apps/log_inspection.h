// SPDX-License-Identifier: BSD-3-Clause
// What a sensor log holds, seen scan by scan.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_LOG_INSPECTION_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_LOG_INSPECTION_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frontend/health.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/odometry_check.h"

namespace gmapping_spa::apps {

// The raw step of the wheels up to a scan.
struct OdometryStep {
  double stamp_s = 0.0;
  double elapsed_s = 0.0;  // since the scan before
  double length_m = 0.0;
  double turn_rad = 0.0;  // absolute
  sensor::OdometryFault fault = sensor::OdometryFault::kNone;
};

struct LogSummary {
  std::int64_t scans = 0;
  double first_stamp_s = 0.0, last_stamp_s = 0.0;  // the least and the greatest
  std::vector<double> periods_s;                   // between neighboring scans
  std::map<std::size_t, std::int64_t> scans_by_beams;

  // Of the first scan.
  double first_beam_rad = 0.0, last_beam_rad = 0.0;
  backend::SE2 robot_T_laser;

  std::vector<std::int64_t> hits_by_meter;  // of the range, from 0 on
  double shortest_hit_m = 0.0, longest_hit_m = 0.0;

  std::int64_t scans_with_odometry = 0;
  std::vector<OdometryStep> steps;  // between neighboring scans that have odometry
  // By their keys, as a run would report them; those of the odometry.
  std::map<std::string, frontend::Finding> findings;
  // Times in which the odometry stood still while the scans changed, of two scans and more.
  std::vector<frontend::Stretch> silent;

  std::vector<backend::SE2> odom_T_robot;  // of the scans that have it
  std::vector<sensor::LaserScan> samples;  // some scans, evenly spread
};

class LogInspector {
 public:
  explicit LogInspector(const sensor::OdometryCheck::Options& options) : check_(options) {}

  // In the order of the reader.
  void Add(const sensor::LaserScan& scan);

  const LogSummary& summary() const { return summary_; }

 private:
  void AddBeams(const sensor::LaserScan& scan);
  void AddOdometry(const sensor::LaserScan& scan);
  void AddSample(const sensor::LaserScan& scan);

  sensor::OdometryCheck check_;
  LogSummary summary_;
  frontend::Health silence_;
  std::optional<sensor::LaserScan> previous_;
  std::optional<sensor::LaserScan> last_moved_;  // the scan with which the reading last changed
  std::int64_t sample_stride_ = 1;
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_LOG_INSPECTION_H_
