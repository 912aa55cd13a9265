// SPDX-License-Identifier: BSD-3-Clause
// All scans of a run in little memory.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_SCAN_ARCHIVE_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_SCAN_ARCHIVE_H_

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/packed_ranges.h"

namespace gmapping_spa::sensor {

// Keeps scans with PackedRanges, and the angles of the beams once for all scans in succession that
// share them.
class ScanArchive {
 public:
  // A scan as it was measured, and the velocity of the robot then: a twist in its frame (m/s, m/s,
  // rad/s). Returns the position at which Get finds the scan: 0, 1, 2, ...
  int Add(const LaserScan& scan, const Eigen::Vector3d& velocity);

  // The time from the first beam of a scan to the last one, s: Get deskews all scans by it, those
  // of before as well.
  void set_sweep_s(double sweep_s) { sweep_s_ = sweep_s; }

  // Scans to come are of another run: those up to here keep the sweep that was found for them.
  void BeginSession();

  LaserScan Get(int position) const;

  // As Add was given it, but for the rounding: not deskewed.
  LaserScan Measured(int position) const;

  double StampOf(int position) const { return scans_.at(position).stamp_s; }
  std::int64_t IndexOf(int position) const { return scans_.at(position).index; }

  // Of each scan its place in the order of the input, by index.
  std::vector<std::size_t> Rows() const;

  // Whether Add was given this scan for the position.
  bool Holds(int position, const LaserScan& scan) const;

  int size() const { return static_cast<int>(scans_.size()); }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(scans_, latest_velocity_, sweep_s_, sessions_);
  }

 private:
  struct Entry {
    std::int64_t index;
    double stamp_s;
    backend::SE2 odom_T_robot;
    backend::SE2 robot_T_laser;
    std::shared_ptr<const std::vector<double>> angles_rad;
    PackedRanges ranges;
    Eigen::Vector3d velocity;
    double sweep_s;  // as the log tells it
    bool has_odometry;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(index, stamp_s, odom_T_robot, robot_T_laser, angles_rad, ranges, velocity, sweep_s,
              has_odometry);
    }
  };
  std::vector<Entry> scans_;
  Eigen::Vector3d latest_velocity_ = Eigen::Vector3d::Zero();
  double sweep_s_ = 0.0;
  struct Session {  // that is over
    int end;        // one past its last scan
    double sweep_s;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(end, sweep_s);
    }
  };
  std::vector<Session> sessions_;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_SCAN_ARCHIVE_H_
