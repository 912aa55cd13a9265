// SPDX-License-Identifier: BSD-3-Clause
// Flags that say how a sensor log is read.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_LOG_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_LOG_FLAGS_H_

#include "experiments/apps/flag_groups.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::apps {

FlagGroups LogFlagGroups();

// Throws std::runtime_error with one line when a flag makes no sense.
sensor::LogOptions LogOptionsFromFlags();

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_LOG_FLAGS_H_
