// SPDX-License-Identifier: BSD-3-Clause
// Beams of a record, or why it has none.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_CHECKED_BEAMS_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_CHECKED_BEAMS_H_

#include <optional>
#include <vector>

#include "frontend/sensor/beams.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::sensor {

// As MakeBeams, with what the options override. `maximum_range_m` is the sensor's own limit, where
// the record says it: a reading there is no return either; some logs leave it at zero. Throws
// MalformedRecord when there is no range, or when the angles span more than a turn or nothing.
std::vector<Beam> CheckedBeams(const std::vector<double>& ranges_m, BeamAngles angles,
                               const LogOptions& options, std::optional<double> maximum_range_m);

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_CHECKED_BEAMS_H_
