// SPDX-License-Identifier: BSD-3-Clause
// The flags of a node: those of gmapping_spa, but for its log.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_NODE_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_NODE_FLAGS_H_

#include <functional>
#include <map>
#include <string>

#include "experiments/apps/flag_groups.h"
#include "experiments/ros/parameters.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::ros {

apps::FlagGroups NodeFlagGroups();

// Throws std::runtime_error with one line when a flag makes no sense.
sensor::LogOptions LogOptionsOfNode();
std::string OutputFolderFromFlags();

// Runs a node as apps::RunApp does: `parameters` as ReadParameters has them, of which flags on the
// command line override those that are flags. Returns the exit status.
int RunNode(int argc, char** argv, const std::map<std::string, std::string>& parameters,
            const std::function<void(const NodeParameters&)>& run);

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_NODE_FLAGS_H_
