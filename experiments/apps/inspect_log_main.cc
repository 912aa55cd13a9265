// SPDX-License-Identifier: BSD-3-Clause
// Says what a sensor log holds, before anybody makes a map of it.
#include <gflags/gflags.h>

#include <iostream>
#include <optional>
#include <stdexcept>

#include "experiments/apps/app.h"
#include "experiments/apps/inspection_picture.h"
#include "experiments/apps/inspection_report.h"
#include "experiments/apps/inspection_text.h"
#include "experiments/apps/json.h"
#include "experiments/apps/log_file.h"
#include "experiments/apps/log_flags.h"
#include "experiments/apps/log_inspection.h"
#include "experiments/apps/output_files.h"

DEFINE_string(
    log, "", "Sensor log: a ROS 1 or ROS 2 bag (file or folder), or a CARMEN log, gzipped or not.");
DEFINE_string(output_dir, "",
              "Folder for the picture inspect.png, made if needed. Empty: no picture.");
DEFINE_bool(json, false, "Print the findings as JSON instead of text.");

namespace gmapping_spa::apps {
namespace {

void Run() {
  if (FLAGS_log.empty()) throw std::runtime_error("--log=FILE is missing");
  const sensor::LogOptions options = LogOptionsFromFlags();
  std::optional<OutputFiles> files;
  if (!FLAGS_output_dir.empty()) files.emplace(FLAGS_output_dir);
  const LogFile log = OpenLogFile(FLAGS_log, options);
  LogInspector inspector(sensor::OdometryCheck::Options{});
  while (const std::optional<sensor::LaserScan> scan = log.reader->Next()) {
    ThrowIfInterrupted();
    inspector.Add(*scan);
  }
  const Json report =
      InspectionReport(inspector.summary(), log.reader->counts(), options, log.bag.get());
  if (files) {
    WriteInspectionPicture(inspector.summary(), files->TemporaryPath("inspect.png"));
    files->Commit();
  }
  if (FLAGS_json) {
    std::cout << TextOf(report) << '\n';
  } else {
    PrintInspection(FLAGS_log, report, std::cout);
  }
}

FlagGroups AllFlagGroups() {
  const FlagGroups output = {{"output", "Input and output", {"log", "output_dir", "json"}}};
  return Join({output, LogFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "says what a sensor log holds, what would be assumed about it, and what to look out for.\n"
      "Usage: inspect_log --log=FILE [--output_dir=DIR] [--json]\n"
      "The picture inspect.png shows the odometry's way with some scans, the ranges and the steps.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
