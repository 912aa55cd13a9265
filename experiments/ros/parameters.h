// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a ROS node: those of slam_gmapping, each honoured or refused with a reason, and
// the flags of gmapping_spa by their names.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_PARAMETERS_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_PARAMETERS_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/apps/flag_groups.h"

namespace gmapping_spa::ros {

// What concerns the node and not the SLAM.
struct NodeOptions {
  std::string map_frame = "map";
  int throttle_scans = 1;  // one of so many scans is taken
  double map_update_interval_s = 5.0;
  double transform_publish_period_s = 0.05;  // 0: map -> odom is not published
  std::optional<double> tf_delay_s;          // nothing: transform_publish_period_s
  // Of a match, summed over the beams of a scan as slam_gmapping has it; nothing: match_min_score.
  std::optional<double> minimum_score;
  double queue_limit_mb = 256.0;   // of scans that wait, and of transforms as much again
  bool exit_on_time_jump = false;  // else no more messages are taken
};

struct NodeParameters {
  NodeOptions node;
  std::vector<std::string> flags;     // words for the command line, before its own
  std::vector<std::string> refusals;  // a line each, for the user
};

// Values are given as text: "0.05", "true", "base_link". `flag_groups` are those of the program.
// Throws std::runtime_error "~<name>: expected ..., found ..." where a value makes no sense.
NodeParameters ReadParameters(const std::map<std::string, std::string>& parameters,
                              const apps::FlagGroups& flag_groups);

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_PARAMETERS_H_
