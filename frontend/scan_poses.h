// SPDX-License-Identifier: BSD-3-Clause
// Poses of all scans, those between the updates of the filter included.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_POSES_H_
#define GMAPPING_SPA_FRONTEND_SCAN_POSES_H_

#include <cstdint>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// Remembers the odometry of each scan and which scans the filter used. A scan in between gets its
// pose from the odometry since the last update; what the next update finds wrong with that odometry
// is spread over the scans in proportion to the motion up to them.
class ScanPoses {
 public:
  // Scans in the order of time. `motion` is the amount of motion since the scan before, in any
  // unit; `is_update` says whether the filter was updated with this scan. The first one must be.
  // `odom_T_robot` is the odometry to fill with: the wheels' or a better one.
  void Add(const sensor::LaserScan& scan, const backend::SE2& odom_T_robot, double motion,
           bool is_update);

  // Says of the latest scan, later, that the filter was updated with it.
  void MakeUpdate() { entries_.back().is_update = true; }
  bool latest_is_update() const { return !entries_.empty() && entries_.back().is_update; }

  // Says later that the filter was updated with the scan added so many before the latest one, and
  // that nothing is known of the motion up to it: it corrects no scan before. There must be no
  // update since.
  void BeginPiece(int scans_back);
  const backend::SE2& OdometryOf(int scans_back) const {
    return entries_[entries_.size() - 1 - scans_back].odom_T_robot;
  }

  // Poses of all scans in the order of the input, given those at the updates.
  backend::Trajectory Fill(const std::vector<backend::SE2>& world_T_updates) const;

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(entries_);
  }

 private:
  struct Entry {
    std::int64_t index = 0;
    double stamp_s = 0.0;
    backend::SE2 odom_T_robot;
    double motion = 0.0;
    bool is_update = false;
    bool begins_piece = false;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(index, stamp_s, odom_T_robot, motion, is_update, begins_piece);
    }
  };
  std::vector<Entry> entries_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SCAN_POSES_H_
