// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/node_flags.h"

#include <gflags/gflags.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "experiments/apps/app.h"
#include "experiments/apps/log_flags.h"
#include "experiments/apps/slam_flags.h"

DEFINE_string(output_dir, "",
              "Folder for the results at the end, as gmapping_spa writes them; made if needed. "
              "Empty: they are not written.");

namespace gmapping_spa::ros {

apps::FlagGroups NodeFlagGroups() {
  const apps::FlagGroups output = {{"output", "Output", {"output_dir"}}};
  return apps::Join({output, apps::LogFlagGroups(), apps::SlamFlagGroups()});
}

sensor::LogOptions LogOptionsOfNode() {
  const sensor::LogOptions options = apps::LogOptionsFromFlags();
  if (!options.scan_topic.empty() || !options.odometry_topic.empty()) {
    throw std::runtime_error(
        "--scan_topic, --odometry_topic: expected none, as a node's topics are remapped "
        "(scan:=base_scan) and odometry comes from tf");
  }
  return options;
}

std::string OutputFolderFromFlags() { return FLAGS_output_dir; }

int RunNode(int argc, char** argv, const std::map<std::string, std::string>& parameters,
            const std::function<void(const NodeParameters&)>& run) {
  // What slam_gmapping has; and who drives a robot does not wait for two seconds of order.
  const auto set_default = [](const char* flag, const char* value) {
    gflags::SetCommandLineOptionWithMode(flag, value, gflags::SET_FLAGS_DEFAULT);
  };
  set_default("base_frame", "base_link");
  set_default("odom_frame", "odom");
  set_default("reorder_window_s", "0.5");
  NodeParameters read;
  try {
    read = ReadParameters(parameters, NodeFlagGroups());
  } catch (const std::runtime_error& error) {
    std::cerr << argv[0] << ": error: " << error.what() << '\n';
    return 1;
  }
  std::vector<char*> words = {argv[0]};
  for (std::string& flag : read.flags) words.push_back(flag.data());
  words.insert(words.end(), argv + 1, argv + argc);
  const int num_words = static_cast<int>(words.size());
  words.push_back(nullptr);
  return apps::RunApp(num_words, words.data(),
                      "a node for ROS that makes a map while the robot drives, in place of "
                      "slam_gmapping.\n"
                      "Usage: slam_node [--flagfile=FILE] [flags]; each flag is a private parameter, "
                      "too",
                      NodeFlagGroups(), [&] { run(read); });
}

}  // namespace gmapping_spa::ros
