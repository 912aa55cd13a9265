// SPDX-License-Identifier: BSD-3-Clause
// A simulated robot that is driven from a page, and maps that grow meanwhile.
#include <gflags/gflags.h>
#include <glog/logging.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backend/enum_names.h"
#include "backend/plugin/plugin_loader.h"
#include "experiments/apps/app.h"
#include "experiments/apps/backend_flags.h"
#include "experiments/apps/drive_record.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/server_flags.h"
#include "experiments/apps/simulation_flags.h"
#include "experiments/apps/slam_flags.h"
#include "experiments/apps/slam_option_names.h"
#include "experiments/drive/drive_session.h"

DEFINE_string(output_dir, "",
              "Folder that the button Save of the page writes to; made if needed. Empty: nothing "
              "can be saved.");
DEFINE_double(speed, 1.0,
              "How many times as fast as real time the robot drives, 0.1 to 100; maps follow as "
              "fast as they can.");
DEFINE_string(replay, "",
              "File commands.csv of a tour that was saved: it is driven again before the page "
              "takes over. Needs the same world, flags and seed to be the same tour.");
DECLARE_uint64(seed);

namespace gmapping_spa::apps {
namespace {

// Of the simulation, what makes no sense with somebody who drives.
constexpr const char* kOfTours[] = {"crowd", "turns_at_way_points", "carry_s", "reverse"};

void CheckFlagsOfTours() {
  for (const char* flag : kOfTours) {
    const auto info = gflags::GetCommandLineFlagInfoOrDie(flag);
    if (info.current_value == info.default_value) continue;
    FailFlag(flag, info.current_value, "expected to be left out: somebody drives, not a tour");
  }
}

drive::VariantChoice ChoiceFromFlags() {
  const SlamOptions options = SlamOptionsFromFlags();
  return {BackendFromFlags(), options.particles, options.correction};
}

void SetFlag(const char* name, const std::string& value) {
  if (gflags::SetCommandLineOption(name, value.c_str()).empty()) {
    throw std::runtime_error(std::string("cannot set --") + name + "=" + value);
  }
}

// What gmapping_spa does with these flags.
drive::VariantSetup MakeVariant(const drive::VariantChoice& choice) {
  const gflags::FlagSaver saver;
  SetFlag("backend", choice.backend);
  SetFlag("particles", std::to_string(choice.particles));
  SetFlag("correction", backend::NameOf(kCorrectionNames, choice.correction));
  LoadOptimizerFromFlags();  // checks, and may change the loss
  return {choice, SlamOptionsFromFlags(), OptimizerLoaderFromFlags()};
}

std::vector<std::string> BackEnds() {
  std::vector<std::string> names = {BackendFromFlags()};
  for (const char* name : {"spa", "ceres", "none"}) {
    if (name == names.front()) continue;
    try {
      backend::LoadOptimizer(name);
      names.emplace_back(name);
    } catch (const std::exception& error) {
      LOG(WARNING) << "the back end " << name << " cannot be chosen: " << error.what();
    }
  }
  return names;
}

std::vector<drive::DriveCommand> CommandsFromFlags() {
  if (FLAGS_replay.empty()) return {};
  std::ifstream in(FLAGS_replay);
  if (!in) throw std::runtime_error(FLAGS_replay + ": cannot be read");
  return drive::ReadCommands(in, FLAGS_replay);
}

drive::DriveSetup SetupFromFlags(const SimulationSetup& setup, double occupied_threshold) {
  drive::DriveSetup drive{.scene = setup.scene,
                          .options = setup.options,
                          .truth = setup.truth,
                          .title = {},
                          .server = ServerOptionsFromFlags(),
                          .make_variant = MakeVariant,
                          .save = {},
                          .is_asked_to_stop = [] { return ReceivedSignal() != 0; }};
  drive.title = {.world = std::filesystem::path(setup.input_files.at("world")).stem().string(),
                 .world_T_start =
                     simulation::WayPointFollower(setup.way_points, setup.options.follower).Start(),
                 .robot_radius_m = setup.options.robot_radius_m,
                 .truth_resolution_m = setup.truth.resolution_m,
                 .map_resolution_m = SlamOptionsFromFlags().resolution_m,
                 .backends = BackEnds()};
  if (FLAGS_output_dir.empty()) return drive;
  drive.save = [&setup, occupied_threshold](const drive::DriveSession& session,
                                            const drive::VariantResults& results) {
    return WriteDrive(setup, session, results, occupied_threshold, FLAGS_output_dir);
  };
  return drive;
}

void Run() {
  CheckFlagsOfTours();
  const double speed = InRange("speed", FLAGS_speed, 0.1, 100.0);
  if (!FLAGS_output_dir.empty()) OutputFiles fails_before_somebody_drives(FLAGS_output_dir);
  const SimulationSetup setup = SimulationFromFlags(FLAGS_seed);
  const std::vector<drive::DriveCommand> commands = CommandsFromFlags();
  const drive::VariantChoice first = ChoiceFromFlags();
  drive::DriveSession session(SetupFromFlags(setup, SlamOptionsFromFlags().occupied_threshold),
                              first);
  session.Replay(commands);
  SayWhereThePageIs(session.port());
  session.Run(speed);
  const std::size_t unsaved = session.tour().steps() - session.saved_steps();
  if (unsaved > 0) std::cerr << "the last " << unsaved << " scans of the tour were not saved\n";
}

FlagGroups AllFlagGroups() {
  const FlagGroups own = {{"drive", "Drive", {"output_dir", "speed", "replay"}}};
  return Join({own, ServerFlagGroups(), SimulationFlagGroups(), SlamFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "serves a page on which you drive a simulated robot by keys, and watch maps grow beside the "
      "truth.\n"
      "Usage: drive --world=FILE [--output_dir=DIR] [flags of simulate and gmapping_spa]\n"
      "The robot starts at the first way point of --path. Saves log.clf, truth.tum, truth.pgm with "
      "truth.yaml,\n"
      "commands.csv, and the trajectory and map of each variant of SLAM.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
