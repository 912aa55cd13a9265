// SPDX-License-Identifier: BSD-3-Clause
// Which covariances a command line asks for.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_COVARIANCE_CHOICE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_COVARIANCE_CHOICE_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gmapping_spa::apps {

// Of which nodes or pairs of nodes, by their ids.
struct CovarianceChoice {
  enum class Kind : std::uint8_t { kAll, kNodes, kPairs };
  Kind kind = Kind::kAll;
  std::vector<std::pair<std::int64_t, std::int64_t>> ids;  // those of nodes twice
};

// Of "all", "3,7,12" or "3:7,12:40". Throws std::runtime_error with one line, which begins with
// `place`.
CovarianceChoice ParseCovarianceChoice(const std::string& place, const std::string& text);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_COVARIANCE_CHOICE_H_
