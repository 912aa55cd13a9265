// SPDX-License-Identifier: BSD-3-Clause
// Flags of the SLAM algorithm: the members of SlamOptions, and its defaults.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_FLAGS_H_

#include "experiments/apps/flag_groups.h"
#include "frontend/api/slam_options.h"

namespace gmapping_spa::apps {

FlagGroups SlamFlagGroups();

// Throws std::runtime_error with one line when a flag makes no sense.
SlamOptions SlamOptionsFromFlags();

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_FLAGS_H_
