// SPDX-License-Identifier: BSD-3-Clause
// A laser that measures one beam after the other while its robot moves.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_MOVING_LASER_H_
#define GMAPPING_SPA_TESTS_FRONTEND_MOVING_LASER_H_

#include <Eigen/Core>

#include "backend/se2.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::synthetic {

// `motion`: of the robot from the first beam to the last one, a twist; `middle`: its pose halfway.
inline sensor::LaserScan ScanOnTheMove(const Walls& walls, const backend::SE2& middle,
                                       const Eigen::Vector3d& motion, const Laser& laser = {}) {
  sensor::LaserScan scan = Scan(walls, middle, laser);
  for (int k = 0; k < laser.beams; ++k) {
    const double part = k / (laser.beams - 1.0) - 0.5;
    const backend::SE2 world_T_laser = middle * backend::Exp(part * motion) * laser.robot_T_laser;
    sensor::Beam& beam = scan.beams[k];
    beam.range_m = Range(walls, world_T_laser * backend::SE2{0, 0, beam.angle_rad});
    beam.status = sensor::BeamStatus::kHit;
    if (beam.range_m < laser.usable_range_m) continue;
    beam.range_m = laser.usable_range_m;
    beam.status = sensor::BeamStatus::kNoReturn;
  }
  return scan;
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_MOVING_LASER_H_
