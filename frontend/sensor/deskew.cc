// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/deskew.h"

#include <cmath>

namespace gmapping_spa::sensor {

using backend::SE2;

LaserScan Deskew(LaserScan scan, const Eigen::Vector3d& motion) {
  if (motion.isZero(0.0)) return scan;
  const SE2 laser_T_robot = Inverse(scan.robot_T_laser);
  for (std::size_t k = 0; k < scan.beams.size(); ++k) {
    Beam& beam = scan.beams[k];
    const SE2 stamp_T_then =
        laser_T_robot * backend::Exp(PlaceInSweep(scan, k) * motion) * scan.robot_T_laser;
    if (beam.status != BeamStatus::kHit) {  // it has no end point
      beam.angle_rad += stamp_T_then.theta;
      continue;
    }
    const Eigen::Vector2d end =
        stamp_T_then * Eigen::Vector2d(beam.range_m * std::cos(beam.angle_rad),
                                       beam.range_m * std::sin(beam.angle_rad));
    beam.range_m = end.norm();
    const double turned_rad = std::atan2(end.y(), end.x()) - beam.angle_rad;
    beam.angle_rad += backend::WrapAngle(turned_rad);  // angles go on growing beyond half a turn
  }
  return scan;
}

}  // namespace gmapping_spa::sensor
