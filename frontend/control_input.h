// SPDX-License-Identifier: BSD-3-Clause
// The control input of the filter: how the robot moved from scan to scan.
#ifndef GMAPPING_SPA_FRONTEND_CONTROL_INPUT_H_
#define GMAPPING_SPA_FRONTEND_CONTROL_INPUT_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "frontend/health.h"
#include "frontend/lidar_odometry.h"
#include "frontend/odometry_scale.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/odometry_check.h"
#include "frontend/stand_still.h"
#include "frontend/unchecked_way.h"

namespace gmapping_spa::frontend {

enum class OdometrySource : std::uint8_t {
  kRaw,       // the log's odometry as it is, right or wrong; scans are not looked at
  kWheel,     // the log's odometry, checked; scan matching says how far to trust it
  kLidar,     // every scan matched with the last ones, the wheels a part of the prior
  kLidarOnly  // scans alone: the log's odometry is not looked at
};

// Checks the wheels, matches the scan, and says what it noticed.
class ControlInput {
 public:
  struct Options {
    OdometrySource source = OdometrySource::kLidar;
    sensor::OdometryCheck::Options check;
    LidarOdometry::Options lidar_odometry;
    friend bool operator==(const Options&, const Options&) = default;
  };

  // `health` must outlive this.
  ControlInput(const Options& options, Health* health);

  // The motion since the scan before. Of the first scan: none.
  ScanMotion AddScan(const sensor::LaserScan& scan);

  // Time from the first beam of a scan to the last one, s, by which scans are to be deskewed; 0
  // where they seem to be measured at once.
  double sweep_s() const { return lidar_odometry_.sweep_s(); }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(check_, lidar_odometry_, odom_T_previous_, stand_still_, has_reported_sweep_,
            odometry_scale_, unchecked_way_, has_contradicted_sweep_, has_reported_calibration_,
            has_seen_, blind_stamps_s_);
  }

 private:
  ScanMotion AsLogged(const sensor::LaserScan& scan);
  void LearnScale(const sensor::OdometryCheck::Step& wheels, const ScanMotion& motion,
                  double stamp_s);
  void ReportFault(const sensor::OdometryCheck::Step& wheels, double stamp_s);
  void ReportBlind(const sensor::LaserScan& scan);
  void ReportSweep(const sensor::LaserScan& scan);
  void ReportCalibration(double stamp_s);
  void ReportUnmatched(const ScanMotion& motion, const sensor::OdometryCheck::Step& wheels,
                       double stamp_s);
  void ReportMatch(const ScanMotion& motion, const sensor::OdometryCheck::Step& wheels,
                   double stamp_s);

  Options options_;
  Health* health_;
  sensor::OdometryCheck check_;
  OdometryScale odometry_scale_;
  LidarOdometry lidar_odometry_;
  std::optional<backend::SE2> odom_T_previous_;  // of kRaw: what the log last said
  UncheckedWay unchecked_way_;
  StandStill stand_still_;  // of kRaw
  bool has_reported_sweep_ = false, has_contradicted_sweep_ = false;
  bool has_reported_calibration_ = false;
  bool has_seen_ = false;               // any obstacle so far
  std::vector<double> blind_stamps_s_;  // of scans without a hit that are not reported yet
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_CONTROL_INPUT_H_
