// SPDX-License-Identifier: BSD-3-Clause
// The report of inspect_log as text.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_TEXT_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_TEXT_H_

#include <ostream>
#include <string>

#include "experiments/apps/json.h"

namespace gmapping_spa::apps {

// Prints what InspectionReport gave for people; `name` is that of the log.
void PrintInspection(const std::string& name, const Json& report, std::ostream& out);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_TEXT_H_
