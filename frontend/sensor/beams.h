// SPDX-License-Identifier: BSD-3-Clause
// From the ranges of a sweep to beams with an angle and a status.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_BEAMS_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_BEAMS_H_

#include <cstddef>
#include <vector>

#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::sensor {

// Beam i points to first_rad + i * step_rad in the frame of the laser.
struct BeamAngles {
  double first_rad = 0.0;
  double step_rad = 0.0;
};

// The angles of a laser whose log tells only the number of beams, as the SICK LMS of the CARMEN
// logs has them: 180 beams from -90 deg in steps of 1 deg, 360 in steps of 0.5 deg; any other
// number (181 and 361 among them) is spread evenly from -90 to 90 deg, both ends included. A single
// beam points straight ahead.
BeamAngles TabulatedAngles(std::size_t num_beams);

// `angles` with what the options say instead: field of view, first angle, flipped mounting.
BeamAngles OverriddenAngles(BeamAngles angles, std::size_t num_beams, const LogOptions& options);

// Beam `beam`. Invalid: nan, negative, or below range_min_m. No return: usable_range_m or more,
// infinity.
Beam MakeBeam(const BeamAngles& angles, std::size_t beam, double range_m, double range_min_m,
              double usable_range_m);
std::vector<Beam> MakeBeams(const std::vector<double>& ranges_m, const BeamAngles& angles,
                            double range_min_m, double usable_range_m);

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_BEAMS_H_
