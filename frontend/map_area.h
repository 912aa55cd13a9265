// SPDX-License-Identifier: BSD-3-Clause
// Guards against odometry that jumps kilometres.
#ifndef GMAPPING_SPA_FRONTEND_MAP_AREA_H_
#define GMAPPING_SPA_FRONTEND_MAP_AREA_H_

#include <Eigen/Geometry>

#include "backend/se2.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// The area that a map must cover: all that particles have been in, with the reach of the beams.
class MapArea {
 public:
  explicit MapArea(double resolution_m) : resolution_m_(resolution_m) {}

  // Throws std::runtime_error when no map can cover the area with a scan taken there: a jump of the
  // odometry must not ask for more than memory holds.
  void Extend(const sensor::LaserScan& scan, const backend::SE2& world_T_robot);

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(area_.min(), area_.max());
  }

 private:
  double resolution_m_;
  Eigen::AlignedBox2d area_{Eigen::Vector2d::Zero()};  // from the origin, the first pose
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_MAP_AREA_H_
