// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/node_flags.h"

#include <gflags/gflags.h>

#include <stdexcept>

#include "experiments/apps/log_flags.h"
#include "experiments/apps/session_flags.h"
#include "experiments/apps/slam_flags.h"

DECLARE_string(resume);

DEFINE_string(output_dir, "",
              "Folder for the results at the end, as gmapping_spa writes them; made if needed. "
              "Empty: they are not written.");

namespace gmapping_spa::ros {

apps::FlagGroups NodeFlagGroups() {
  const apps::FlagGroups output = {{"output", "Output", {"output_dir"}}};
  return apps::Join(
      {output, apps::LogFlagGroups(), apps::SlamFlagGroups(), apps::SessionFlagGroups()});
}

sensor::LogOptions LogOptionsOfNode() {
  sensor::LogOptions options = apps::LogOptionsFromFlags();
  if (!options.scan_topic.empty() || !options.odometry_topic.empty()) {
    throw std::runtime_error(
        "--scan_topic, --odometry_topic: expected none, as a node's topics are remapped "
        "(scan:=base_scan) and odometry comes from tf");
  }
  if (!FLAGS_resume.empty()) {
    throw std::runtime_error(
        "--resume: expected none, as the scans of its run would have to come again: gmapping_spa "
        "takes it with a bag. --map_session goes on in its map");
  }
  return options;
}

std::string OutputFolderFromFlags() { return FLAGS_output_dir; }

}  // namespace gmapping_spa::ros
