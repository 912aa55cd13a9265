// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/checked_beams.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "frontend/sensor/record_fields.h"

namespace gmapping_spa::sensor {

std::vector<Beam> CheckedBeams(const std::vector<double>& ranges_m, BeamAngles angles,
                               const LogOptions& options, std::optional<double> maximum_range_m) {
  if (ranges_m.empty()) throw MalformedRecord("expected at least one range, found 0 of them");
  angles = OverriddenAngles(angles, ranges_m.size(), options);
  const double span_rad = std::abs(angles.step_rad) * static_cast<double>(ranges_m.size() - 1);
  constexpr double kMaxSpan = 2.0 * std::numbers::pi * 1.01;  // a turn, and rounded resolutions
  if (ranges_m.size() > 1 && !(span_rad > 0.0 && span_rad <= kMaxSpan)) {
    throw MalformedRecord("expected beams within one turn, found them to span " +
                          std::to_string(span_rad) + " rad");
  }
  const double usable_range_m = maximum_range_m && *maximum_range_m > options.range_min_m
                                    ? std::min(options.usable_range_m, *maximum_range_m)
                                    : options.usable_range_m;
  return MakeBeams(ranges_m, angles, options.range_min_m, usable_range_m);
}

}  // namespace gmapping_spa::sensor
