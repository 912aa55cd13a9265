// SPDX-License-Identifier: BSD-3-Clause
// Runs SLAM on a simulated robot, without a log in between.
#include <gflags/gflags.h>

#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

#include "experiments/apps/app.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/simulation_flags.h"
#include "experiments/apps/slam_flags.h"
#include "experiments/apps/slam_run.h"
#include "experiments/apps/view_flags.h"
#include "experiments/simulation/scan_player.h"

DEFINE_string(output_dir, "", "Folder for the results of SLAM and the truth; made if needed.");
DECLARE_string(world);
DECLARE_uint64(seed);

namespace gmapping_spa::apps {
namespace {

Json Identify(const std::map<std::string, std::string>& input_files) {
  Json json;
  for (const auto& [flag, path] : input_files) {
    const FileIdentity identity = IdentifyFile(path);
    json[flag] = {{"sha256", identity.sha256}, {"bytes", identity.bytes}};
  }
  return json;
}

void Run() {
  if (ViewsFinishedRuns()) return ViewFinishedRuns();
  if (FLAGS_output_dir.empty()) throw std::runtime_error("--output_dir=DIR is missing");
  const SimulationSetup setup = SimulationFromFlags(FLAGS_seed);
  SlamRun slam;
  OutputFiles files(FLAGS_output_dir);
  const auto live_view = LiveViewFromFlags(FLAGS_world, slam.gmapping().resolution_m());
  slam.SetObserver(live_view.get());
  simulation::ScanPlayer player([&](const sensor::LaserScan& scan) {
    ThrowIfInterrupted();
    slam.AddScan(scan);
  });
  const simulation::SimulationSummary summary =
      simulation::Simulate(setup.scene, setup.way_points, setup.options, &player);
  WriteTruth(setup, summary, &files);
  slam.Finish([&] { return Identify(setup.input_files); }, {}, &files);
  files.Commit();
  std::cout << slam.counts().scans << " scans over " << summary.path_length_m << " m, "
            << slam.counts().updates << " updates; results in " << FLAGS_output_dir << std::endl;
  if (live_view) EndLiveView(live_view.get());
}

FlagGroups AllFlagGroups() {
  const FlagGroups output = {{"output", "Output", {"output_dir"}}};
  return Join({output, ViewFlagGroups(), SimulationFlagGroups(), SlamFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  gmapping_spa::apps::CompleteViewFlag(argc, argv);
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "makes a map and a trajectory of a simulated tour: what simulate and gmapping_spa do one "
      "after the other, with the same --seed.\n"
      "Usage: simulate_slam --world=FILE --output_dir=DIR [--view] [flags of simulate and "
      "gmapping_spa]\n"
      "       simulate_slam --view=DIR[,DIR]\n"
      "Writes what gmapping_spa writes, and truth.tum, truth.pgm and truth.yaml, with\n"
      "--obstacles truth_obstacles.pgm and truth_obstacles.yaml.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
