// SPDX-License-Identifier: BSD-3-Clause
// Values that several messages of Foxglove have.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_VALUES_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_VALUES_H_

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "backend/se2.h"

namespace gmapping_spa::view {

// Of a stamp in s, not below 0.
inline std::uint64_t Nanoseconds(double stamp_s) {
  return static_cast<std::uint64_t>(std::llround(std::fmax(stamp_s, 0.0) * 1e9));
}

inline nlohmann::json FoxgloveTime(double stamp_s) {
  const std::uint64_t time_ns = Nanoseconds(stamp_s);
  return {{"sec", time_ns / 1'000'000'000}, {"nsec", time_ns % 1'000'000'000}};
}

inline nlohmann::json FoxglovePoint(double x_m, double y_m) {
  return {{"x", x_m}, {"y", y_m}, {"z", 0.0}};
}

inline nlohmann::json FoxglovePose(const backend::SE2& pose) {
  return {{"position", FoxglovePoint(pose.x, pose.y)},
          {"orientation",
           {{"x", 0.0},
            {"y", 0.0},
            {"z", std::sin(pose.theta / 2.0)},
            {"w", std::cos(pose.theta / 2.0)}}}};
}

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_VALUES_H_
