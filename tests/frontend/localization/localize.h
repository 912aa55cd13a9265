// SPDX-License-Identifier: BSD-3-Clause
// Robots that drive until they are found in a map.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LOCALIZATION_LOCALIZE_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LOCALIZATION_LOCALIZE_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "frontend/localization/localizer.h"
#include "tests/frontend/localization/known_hall.h"

namespace gmapping_spa::localization {

struct Outcome {
  std::optional<Located> located;
  std::size_t scan = 0;  // by which it was found
};

inline Outcome Localize(const map::OccupancyGrid& map,
                        const std::vector<sensor::LaserScan>& scans) {
  Localizer localizer({}, &map);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const backend::SE2 motion =
        k > 0 ? Between(scans[k - 1].odom_T_robot, scans[k].odom_T_robot) : backend::SE2{};
    if (const auto located = localizer.AddScan(scans[k], motion).located) return {located, k};
  }
  return {};
}

}  // namespace gmapping_spa::localization

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LOCALIZATION_LOCALIZE_H_
