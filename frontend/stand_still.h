// SPDX-License-Identifier: BSD-3-Clause
// Tells odometry that stands still while the robot moves, from what the scans see alone.
#ifndef GMAPPING_SPA_FRONTEND_STAND_STILL_H_
#define GMAPPING_SPA_FRONTEND_STAND_STILL_H_

#include <vector>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// For where scans are not matched. Takes the scans in order.
class StandStill {
 public:
  // `unchanged`: the odometry reads what it read at the scan before. Whether the scan contradicts
  // that the robot has stood still since its odometry last moved: a quarter of the beams that hit
  // something see it half a metre nearer or farther by now. People who walk by change fewer.
  bool IsContradicted(const sensor::LaserScan& scan, bool unchanged);

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(first_beams_);
  }

 private:
  std::vector<sensor::Beam> first_beams_;  // of the scan at which the odometry last moved
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_STAND_STILL_H_
