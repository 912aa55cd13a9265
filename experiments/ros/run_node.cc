// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/run_node.h"

#include <gflags/gflags.h>

#include <iostream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "experiments/apps/app.h"
#include "experiments/ros/node_flags.h"

namespace gmapping_spa::ros {

bool AsksForHelp(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.starts_with("--help") || word.starts_with("-help") || word == "--version") return true;
  }
  return false;
}

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
                      "Usage: slam_node [--flagfile=FILE] [flags]\n"
                      "Each flag is a private parameter as well.",
                      NodeFlagGroups(), [&] { run(read); });
}

}  // namespace gmapping_spa::ros
