#include "frontend/scan_matching/scan_points.h"

#include <cmath>

namespace gmapping_spa::scan_matching {

ScanPoints MakeScanPoints(const sensor::LaserScan& scan) {
  ScanPoints points;
  points.reserve(scan.beams.size());
  const backend::SE2& mount = scan.robot_T_laser;
  for (const sensor::Beam& beam : scan.beams) {
    if (beam.status != sensor::BeamStatus::kHit) continue;
    const double c = std::cos(mount.theta + beam.angle_rad);
    const double s = std::sin(mount.theta + beam.angle_rad);
    points.push_back({mount.x + beam.range_m * c, mount.y + beam.range_m * s, -c, -s});
  }
  return points;
}

}  // namespace gmapping_spa::scan_matching
