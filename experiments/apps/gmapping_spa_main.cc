// SPDX-License-Identifier: BSD-3-Clause
// Runs SLAM on a sensor log and writes trajectory, map, picture, pose graph and run record.
#include <gflags/gflags.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "experiments/apps/app.h"
#include "experiments/apps/log_file.h"
#include "experiments/apps/log_flags.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/progress_bar.h"
#include "experiments/apps/session_flags.h"
#include "experiments/apps/session_log.h"
#include "experiments/apps/session_saver.h"
#include "experiments/apps/slam_flags.h"
#include "experiments/apps/slam_run.h"
#include "experiments/apps/view_flags.h"

DEFINE_string(
    log, "",
    "Sensor log: a ROS 1 or ROS 2 bag (file or folder), a CARMEN log, gzipped or not, or the "
    "session file of another run, whose scans are read.");
DEFINE_string(output_dir, "",
              "Folder for the trajectory, map, pose graph and record of the run; made if needed.");

namespace gmapping_spa::apps {
namespace {

// `saver`: null where no session is written.
sensor::LogCounts ProcessLog(const sensor::LogOptions& options, SlamRun* slam,
                             SessionSaver* saver) {
  const LogFile log =
      IsSessionFile(FLAGS_log) ? OpenSessionLog(FLAGS_log) : OpenLogFile(FLAGS_log, options);
  ProgressBar progress("slam", ProgressTotal(log, FLAGS_log));
  while (const std::optional<sensor::LaserScan> scan = log.reader->Next()) {
    if (ReceivedSignal() != 0) break;
    slam->AddScan(*scan);
    if (saver != nullptr && saver->IsDue() && !slam->CatchesUp()) {
      saver->WriteCheckpoint(slam->MakeSession(FLAGS_log));
    }
    progress.Update(log.reader->counts().at(log.progress_count));
  }
  return log.reader->counts();
}

// Told before the run is finished, with what the user can do about it.
void CheckThatBeamsHit(const sensor::LogCounts& counts, const sensor::LogOptions& options) {
  if (counts.at("beams_hit") > 0) return;
  std::ostringstream message;
  message << FLAGS_log << ": no beam of any scan ended between " << options.range_min_m << " and "
          << options.usable_range_m << " m (" << counts.at("beams_no_return")
          << " were longer): are ranges in cm or mm, or is --usable_range_m too short?";
  throw std::runtime_error(message.str());
}

Json LogToJson(const sensor::LogCounts& counts) {
  Json json = IdentifyLog(FLAGS_log);
  json["records"] = counts;
  return json;
}

void Run() {
  if (ViewsFinishedRuns()) return ViewFinishedRuns();
  if (FLAGS_log.empty()) throw std::runtime_error("--log=FILE is missing");
  if (FLAGS_output_dir.empty()) throw std::runtime_error("--output_dir=DIR is missing");
  // Pipes would be empty when they are read again: for the progress and for the hash.
  if (std::filesystem::exists(FLAGS_log) && !std::filesystem::is_regular_file(FLAGS_log) &&
      !std::filesystem::is_directory(FLAGS_log)) {
    throw std::runtime_error(FLAGS_log + ": expected a regular file, which can be read repeatedly");
  }
  const sensor::LogOptions log_options = LogOptionsFromFlags();
  SlamRun slam;
  BeginAsFlagsSay(&slam);
  const std::unique_ptr<SessionSaver> saver = MakeSessionSaver(&slam);
  OutputFiles files(FLAGS_output_dir);
  const auto live_view = LiveViewFromFlags(FLAGS_log, slam.gmapping().resolution_m());
  slam.SetObserver(live_view.get());
  const sensor::LogCounts log_counts = ProcessLog(log_options, &slam, saver.get());
  if (slam.counts().updates == 0 || slam.CatchesUp()) ThrowIfInterrupted();  // nothing new
  slam.CheckThatSessionEnded();
  CheckThatBeamsHit(log_counts, log_options);
  if (saver != nullptr) saver->WriteLast(slam.MakeSession(FLAGS_log));
  const bool complete = slam.Finish([&] { return LogToJson(log_counts); }, log_counts, &files);
  files.Commit();
  const frontend::ImprovedGmapping::Counts& counts = slam.counts();
  if (ReceivedSignal() != 0) {
    throw Interrupted("interrupted: the results in " + FLAGS_output_dir + " are " +
                      (complete ? std::string("complete")
                                : "those of the first " + std::to_string(counts.scans) +
                                      " scans, without the final optimization"));
  }
  std::cout << counts.scans << " scans, " << counts.updates << " updates, " << counts.resamplings
            << " resamplings" << slam.WordsOnLocalization() << "; results in " << FLAGS_output_dir
            << std::endl;
  if (live_view) EndLiveView(live_view.get());
}

FlagGroups AllFlagGroups() {
  const FlagGroups output = {{"output", "Input and output", {"log", "output_dir"}}};
  return Join({output, SessionFlagGroups(), ViewFlagGroups(), LogFlagGroups(), SlamFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  gmapping_spa::apps::CompleteViewFlag(argc, argv);
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "makes a map and a trajectory from a sensor log.\n"
      "Usage: gmapping_spa --log=FILE --output_dir=DIR [--flagfile=FILE] [--view] [flags]\n"
      "       gmapping_spa --view=DIR[,DIR]\n"
      "Writes the trajectory (trajectory.tum, trajectory.kitti with times.txt), the map (map.pgm "
      "with map.yaml, map.png, map_cells.png), the pose graph (graph.g2o with graph.stamps), "
      "loop_closures.csv and run.json,\nwith --localize localization.csv, too.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
