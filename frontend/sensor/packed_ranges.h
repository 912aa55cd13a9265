// SPDX-License-Identifier: BSD-3-Clause
// The ranges of a scan in little memory.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_PACKED_RANGES_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_PACKED_RANGES_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::sensor {

// Ranges and statuses of beams, at 2 bytes a beam where all ranges are whole centimeters or
// millimeters, as most lasers measure and logs are written, and at 4 otherwise. Rounds ranges to
// float (4 um at 40 m) and nothing else.
class PackedRanges {
 public:
  PackedRanges() = default;
  explicit PackedRanges(const std::vector<Beam>& beams);

  std::size_t size() const { return unit_m_ > 0.0 ? counts_.size() : floats_.size(); }
  Beam BeamAt(std::size_t k, double angle_rad) const;
  friend bool operator==(const PackedRanges&, const PackedRanges&) = default;

  // For sessions (frontend/session): always as floats.
  template <typename Archive>
  void serialize(Archive& archive) {
    std::vector<float> signed_m = SignedRanges();
    archive(signed_m);
    *this = PackedRanges(std::move(signed_m));
  }

 private:
  // Negative: no return up to there; 0: invalid.
  explicit PackedRanges(std::vector<float> signed_m);
  std::vector<float> SignedRanges() const;
  float SignedRange(std::size_t k) const;

  double unit_m_ = 0.0;               // of the counts; 0: there are none, but floats
  std::vector<std::int16_t> counts_;  // signed likewise
  std::vector<float> floats_;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_PACKED_RANGES_H_
