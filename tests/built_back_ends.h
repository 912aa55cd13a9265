// SPDX-License-Identifier: BSD-3-Clause
// Which back ends this build has.
#ifndef GMAPPING_SPA_TESTS_BUILT_BACK_ENDS_H_
#define GMAPPING_SPA_TESTS_BUILT_BACK_ENDS_H_

#include <initializer_list>
#include <string>
#include <vector>

namespace gmapping_spa {

inline constexpr bool kHasCeres = GMAPPING_SPA_CERES;

// `names` without those that were left out of the build.
inline std::vector<const char*> Built(std::initializer_list<const char*> names) {
  std::vector<const char*> built;
  for (const char* name : names) {
    if (kHasCeres || std::string(name) != "ceres") built.push_back(name);
  }
  return built;
}

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_TESTS_BUILT_BACK_ENDS_H_
