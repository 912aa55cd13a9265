// SPDX-License-Identifier: BSD-3-Clause
// How a node begins and ends.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_RUN_NODE_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_RUN_NODE_H_

#include <functional>
#include <map>
#include <string>

#include "experiments/ros/parameters.h"

namespace gmapping_spa::ros {

// Whether words ask for what needs no ROS master.
bool AsksForHelp(int argc, char** argv);

// Runs a node as apps::RunApp does: `parameters` as ReadParameters has them, of which flags on the
// command line override those that are flags. Returns the exit status.
int RunNode(int argc, char** argv, const std::map<std::string, std::string>& parameters,
            const std::function<void(const NodeParameters&)>& run);

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_RUN_NODE_H_
