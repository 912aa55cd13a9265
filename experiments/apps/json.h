// SPDX-License-Identifier: BSD-3-Clause
// How results are printed as JSON.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_JSON_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_JSON_H_

#include <nlohmann/json.hpp>
#include <string>

#include "experiments/metrics/statistics.h"

namespace gmapping_spa::apps {

// Keeps the order of its keys, so that output reads and compares well.
using Json = nlohmann::ordered_json;

// For people and files. Names out of a log that are no UTF-8 must not cost the rest.
inline std::string TextOf(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

inline Json ToJson(const metrics::Statistics& statistics) {
  return {{"mean", statistics.mean}, {"std", statistics.std}, {"median", statistics.median},
          {"rmse", statistics.rmse}, {"min", statistics.min}, {"max", statistics.max}};
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_JSON_H_
