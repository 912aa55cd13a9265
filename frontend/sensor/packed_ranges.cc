// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/packed_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gmapping_spa::sensor {
namespace {

constexpr double kUnits_m[] = {0.01, 0.001};

float InMeters(std::int16_t count, double unit_m) { return static_cast<float>(count * unit_m); }

float Signed(const Beam& beam) {
  const auto range_m = static_cast<float>(beam.range_m);
  switch (beam.status) {
    case BeamStatus::kHit:
      return range_m;
    case BeamStatus::kNoReturn:
      return -range_m;
    case BeamStatus::kInvalid:
      break;
  }
  return 0.0f;
}

std::vector<float> Signed(const std::vector<Beam>& beams) {
  std::vector<float> signed_m;
  signed_m.reserve(beams.size());
  for (const Beam& beam : beams) signed_m.push_back(Signed(beam));
  return signed_m;
}

// Whether the unit holds all of them as they are.
bool Count(const std::vector<float>& signed_m, double unit_m, std::vector<std::int16_t>* counts) {
  counts->clear();
  counts->reserve(signed_m.size());
  for (const float range_m : signed_m) {
    const double count = std::round(range_m / unit_m);
    if (!(std::abs(count) <= std::numeric_limits<std::int16_t>::max())) return false;
    counts->push_back(static_cast<std::int16_t>(count));
    if (InMeters(counts->back(), unit_m) != range_m) return false;
  }
  return true;
}

}  // namespace

PackedRanges::PackedRanges(const std::vector<Beam>& beams) : PackedRanges(Signed(beams)) {}

PackedRanges::PackedRanges(std::vector<float> signed_m) {
  for (const double unit_m : kUnits_m) {
    if (!Count(signed_m, unit_m, &counts_)) continue;
    unit_m_ = unit_m;
    return;
  }
  counts_ = {};
  floats_ = std::move(signed_m);
}

float PackedRanges::SignedRange(std::size_t k) const {
  return unit_m_ > 0.0 ? InMeters(counts_[k], unit_m_) : floats_[k];
}

std::vector<float> PackedRanges::SignedRanges() const {
  std::vector<float> signed_m(size());
  for (std::size_t k = 0; k < signed_m.size(); ++k) signed_m[k] = SignedRange(k);
  return signed_m;
}

Beam PackedRanges::BeamAt(std::size_t k, double angle_rad) const {
  const float range_m = SignedRange(k);
  if (range_m > 0.0f) return {angle_rad, range_m, BeamStatus::kHit};
  if (range_m < 0.0f) return {angle_rad, -range_m, BeamStatus::kNoReturn};
  return {angle_rad, 0.0, BeamStatus::kInvalid};
}

}  // namespace gmapping_spa::sensor
