// SPDX-License-Identifier: BSD-3-Clause
// Simulates a robot's tour of a building: its sensor log, its true trajectory and the true map.
#include <gflags/gflags.h>
#include <glog/logging.h>

#include <stdexcept>
#include <string>

#include "experiments/apps/app.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/simulation_flags.h"
#include "experiments/simulation/carmen_writer.h"

DEFINE_string(output_dir, "",
              "Folder for log.clf, truth.tum, truth.pgm and truth.yaml, and with --obstacles "
              "truth_obstacles.pgm and truth_obstacles.yaml; made if needed.");
DEFINE_uint64(
    seed, gmapping_spa::simulation::SimulationOptions().seed,
    "Seed of all random numbers of the simulation: the same flags and seed give the same files.");

namespace gmapping_spa::apps {
namespace {

// A log that can be interrupted.
class LogWriter : public simulation::CarmenWriter {
 public:
  using CarmenWriter::CarmenWriter;
  void OnOdometry(const simulation::OdometryReading& reading) override {
    ThrowIfInterrupted();
    CarmenWriter::OnOdometry(reading);
  }
};

void Run() {
  if (FLAGS_output_dir.empty()) throw std::runtime_error("--output_dir=DIR is missing");
  const SimulationSetup setup = SimulationFromFlags(FLAGS_seed);
  OutputFiles files(FLAGS_output_dir);
  simulation::SimulationSummary summary;
  files.Write("log.clf", [&](std::ostream& out) {
    LogWriter log(out);
    summary = simulation::Simulate(setup.scene, setup.way_points, setup.options, &log);
  });
  WriteTruth(setup, summary, &files);
  files.Commit();

  const backend::SE2 end = summary.world_T_robot.back().world_T_robot;
  const backend::SE2 odometry_end =
      summary.world_T_robot.front().world_T_robot * summary.odom_T_robot;
  LOG(INFO) << summary.world_T_robot.size() << " scans over " << summary.path_length_m << " m in "
            << summary.world_T_robot.back().stamp_s << " s; odometry ends "
            << (odometry_end.translation() - end.translation()).norm() << " m off, "
            << summary.slips << " slips, " << summary.bumps << " bumps";
}

FlagGroups AllFlagGroups() {
  const FlagGroups output = {{"output", "Output", {"output_dir", "seed"}}};
  return Join({output, SimulationFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "simulates a robot with a laser that drives a tour of a building.\n"
      "Usage: simulate --world=FILE --output_dir=DIR [--path=FILE] [--seed=S] ...\n"
      "Writes log.clf (CARMEN), truth.tum (true pose at each scan) and the true map truth.pgm with "
      "truth.yaml.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
