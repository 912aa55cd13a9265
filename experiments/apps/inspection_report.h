// SPDX-License-Identifier: BSD-3-Clause
// What inspect_log says of a log.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_REPORT_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_REPORT_H_

#include "experiments/apps/json.h"
#include "experiments/apps/log_inspection.h"
#include "frontend/rosbag/open_bag.h"
#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::apps {

// All that was found, with advice for whoever wants to map the log. `counts` are those of the
// log's reader at its end. The log must have a scan. `bag` is what a bag holds, null for other
// logs.
Json InspectionReport(const LogSummary& summary, const sensor::LogCounts& counts,
                      const sensor::LogOptions& options, const rosbag::BagReport* bag = nullptr);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_REPORT_H_
