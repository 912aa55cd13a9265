// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/beams.h"

#include <cmath>
#include <numbers>

namespace gmapping_spa::sensor {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

Beam MakeBeam(const BeamAngles& angles, std::size_t beam, double range_m, double range_min_m,
              double usable_range_m) {
  const double angle_rad = angles.first_rad + static_cast<double>(beam) * angles.step_rad;
  // Written so that nan fails the comparison.
  if (!(range_m >= range_min_m)) return {angle_rad, 0.0, BeamStatus::kInvalid};
  if (range_m >= usable_range_m) return {angle_rad, usable_range_m, BeamStatus::kNoReturn};
  return {angle_rad, range_m, BeamStatus::kHit};
}

BeamAngles TabulatedAngles(std::size_t num_beams) {
  if (num_beams == 1) return {0.0, 0.0};
  // These two leave out the last beam, at 90 deg.
  const bool open_end = num_beams == 180 || num_beams == 360;
  const std::size_t num_steps = open_end ? num_beams : num_beams - 1;
  return {-kPi / 2.0, kPi / static_cast<double>(num_steps)};
}

BeamAngles OverriddenAngles(BeamAngles angles, std::size_t num_beams, const LogOptions& options) {
  if (options.fov_rad && num_beams > 1) {
    angles = {-*options.fov_rad / 2.0, *options.fov_rad / static_cast<double>(num_beams - 1)};
  }
  if (options.angle_min_rad) angles.first_rad = *options.angle_min_rad;
  if (options.flipped) return {-angles.first_rad, -angles.step_rad};
  return angles;
}

std::vector<Beam> MakeBeams(const std::vector<double>& ranges_m, const BeamAngles& angles,
                            double range_min_m, double usable_range_m) {
  std::vector<Beam> beams;
  beams.reserve(ranges_m.size());
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    beams.push_back(MakeBeam(angles, i, ranges_m[i], range_min_m, usable_range_m));
  }
  return beams;
}

}  // namespace gmapping_spa::sensor
