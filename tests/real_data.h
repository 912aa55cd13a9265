// SPDX-License-Identifier: BSD-3-Clause
// Where tests find the real data sets, which are not part of the project.
#ifndef GMAPPING_SPA_TESTS_REAL_DATA_H_
#define GMAPPING_SPA_TESTS_REAL_DATA_H_

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace gmapping_spa {

// The path of `file` in the folder $GMAPPING_SPA_DATA (by default GMAPPING_SPA_DEFAULT_DATA, a
// compile definition of the test), or nothing where it is absent; GTEST_SKIP() then.
inline std::optional<std::string> RealDataPath(const std::string& file) {
  const char* folder = std::getenv("GMAPPING_SPA_DATA");
  const std::filesystem::path path =
      std::filesystem::path(folder != nullptr ? folder : GMAPPING_SPA_DEFAULT_DATA) / file;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path.string();
}

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_TESTS_REAL_DATA_H_
