// SPDX-License-Identifier: BSD-3-Clause
// The part of a scan that scan matching uses, prepared once per scan for all particles.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCAN_POINTS_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCAN_POINTS_H_

#include <vector>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::scan_matching {

// The end point of a beam that hit, in the robot frame, and the unit vector from there back to the
// laser.
struct ScanPoint {
  double x_m = 0.0;
  double y_m = 0.0;
  double back_x = 0.0;
  double back_y = 0.0;
  double range_m = 0.0;  // from the laser
  // What the beam counts as evidence, in [0.1, 1]: beams that end close to each other see the same
  // thing, and a person beside the laser is no more than one thing.
  double weight = 1.0;
  // Unit normal of the surface there, from the neighboring beams; (0, 0) where they do not meet
  // one smooth surface.
  double normal_x = 0.0;
  double normal_y = 0.0;
  double normal_variance = 0.0;  // rad^2, from the noise of the ranges
  double in_sweep = 0.0;         // when it was measured: sensor::PlaceInSweep

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(x_m, y_m, back_x, back_y, range_m, weight, normal_x, normal_y, normal_variance,
            in_sweep);
  }
};
using ScanPoints = std::vector<ScanPoint>;

// All hits of a scan, in the order of its beams.
ScanPoints MakeScanPoints(const sensor::LaserScan& scan);

// The same without normals, in half the time.
ScanPoints MakeEndPoints(const sensor::LaserScan& scan);

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCAN_POINTS_H_
