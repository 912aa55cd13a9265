// SPDX-License-Identifier: BSD-3-Clause
// How results are printed as JSON.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_JSON_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_JSON_H_

#include <nlohmann/json.hpp>

#include "experiments/metrics/statistics.h"

namespace gmapping_spa::apps {

// Keeps the order of its keys, so that output reads and compares well.
using Json = nlohmann::ordered_json;

inline Json ToJson(const metrics::Statistics& statistics) {
  return {{"mean", statistics.mean}, {"std", statistics.std}, {"median", statistics.median},
          {"rmse", statistics.rmse}, {"min", statistics.min}, {"max", statistics.max}};
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_JSON_H_
