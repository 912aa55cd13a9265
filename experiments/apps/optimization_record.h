// SPDX-License-Identifier: BSD-3-Clause
// What optimize_graph says of an optimization, as JSON.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_OPTIMIZATION_RECORD_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_OPTIMIZATION_RECORD_H_

#include <nlohmann/json.hpp>
#include <string>

#include "backend/graph/g2o_io.h"
#include "backend/plugin/optimizer.h"

namespace gmapping_spa::apps {

// `graph`, read from `input` with `remarks`, is the optimized one. The options are those of the
// flags.
nlohmann::ordered_json OptimizationRecord(const std::string& input, const backend::PoseGraph& graph,
                                          const backend::G2oRemarks& remarks,
                                          const backend::Summary& summary, double cpu_s);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_OPTIMIZATION_RECORD_H_
