// SPDX-License-Identifier: BSD-3-Clause
// Numbers and poses for pages.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_JSON_VALUES_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_JSON_VALUES_H_

#include <cmath>
#include <nlohmann/json.hpp>

#include "backend/se2.h"
#include "experiments/view/message.h"

namespace gmapping_spa::view {

// Short, and JSON knows no nan.
inline nlohmann::json Rounded(double value, double scale) {
  return std::isfinite(value) ? nlohmann::json(std::round(value * scale) / scale)
                              : nlohmann::json();
}
inline nlohmann::json Millimeters(double value_m) { return Rounded(value_m, 1e3); }
inline nlohmann::json Milliradians(double value_rad) { return Rounded(value_rad, 1e4); }
inline nlohmann::json Seconds(double value_s) { return Rounded(value_s, 1e3); }

inline nlohmann::json PoseJson(const backend::SE2& pose) {
  return {Millimeters(pose.x), Millimeters(pose.y), Milliradians(pose.theta)};
}

// Text that came from a file may not be UTF-8.
inline MessagePtr Dumped(const nlohmann::json& message) {
  return TextMessage(message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_JSON_VALUES_H_
