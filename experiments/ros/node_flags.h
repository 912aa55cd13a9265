// SPDX-License-Identifier: BSD-3-Clause
// The flags of a node: those of gmapping_spa, but for its log.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_NODE_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_NODE_FLAGS_H_

#include <string>

#include "experiments/apps/flag_groups.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::ros {

apps::FlagGroups NodeFlagGroups();

// Throws std::runtime_error with one line when a flag makes no sense.
sensor::LogOptions LogOptionsOfNode();
std::string OutputFolderFromFlags();

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_NODE_FLAGS_H_
