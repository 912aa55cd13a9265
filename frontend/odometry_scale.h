// SPDX-License-Identifier: BSD-3-Clause
// Odometry in other units than the scans.
#ifndef GMAPPING_SPA_FRONTEND_ODOMETRY_SCALE_H_
#define GMAPPING_SPA_FRONTEND_ODOMETRY_SCALE_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::frontend {

// Learns by which factor the odometry's ways are too long or too short: feet or millimeters instead
// of meters, a wrong number of ticks a turn. Only errors that no slip explains count: what is
// smaller is noise of the odometry.
class OdometryScale {
 public:
  // What ways of the odometry are to be multiplied by; 1 until another is proved.
  double factor() const { return factor_; }
  // The unit with this factor, as people call it ("feet"); empty where there is none.
  const char* unit() const;

  // The motion from scan to scan as the odometry tells it, and as it was. Returns whether that
  // proves another factor.
  bool Add(const backend::SE2& told, const backend::SE2& motion);
  // One of both is not known.
  void Skip();

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(factor_, log_ratios_, told_, motion_);
  }

 private:
  std::optional<double> FactorOf(std::size_t count) const;
  bool Learn();

  double factor_ = 1.0;
  std::vector<double> log_ratios_;  // of the last stretches: way of the scans over way told
  backend::SE2 told_, motion_;      // of the stretch at hand
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_ODOMETRY_SCALE_H_
