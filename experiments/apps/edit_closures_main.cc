// SPDX-License-Identifier: BSD-3-Clause
// Results of a run whose loop closures somebody has edited.
#include <gflags/gflags.h>

#include <filesystem>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>

#include "experiments/apps/app.h"
#include "experiments/apps/backend_flags.h"
#include "experiments/apps/closure_edits.h"
#include "experiments/apps/closure_rows.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/session_saver.h"
#include "experiments/apps/slam_flags.h"
#include "experiments/apps/slam_run.h"
#include "frontend/session/session_file.h"
#include "frontend/session/state.h"

DEFINE_string(session, "", "File of the session that gmapping_spa --save_session has written.");
DEFINE_string(
    closures, "",
    "File of the edited loop_closures.csv. Its column verdict counts: accepted, rejected, "
    "add (a new row with old_node, node and, if known, x_m, y_m, theta_rad), or as it was.");
DEFINE_string(output_dir, "",
              "Folder for the results, as gmapping_spa writes them; made if needed.");
DEFINE_string(
    save_session, "",
    "File for the session with these closures: gmapping_spa --resume goes on from it, and "
    "edit_closures may edit it again. Empty: none.");
DEFINE_bool(refine_scans, false,
            "Align all scans with the map in the end, as gmapping_spa does in --refine rounds.");

DECLARE_int32(refine);

namespace gmapping_spa::apps {
namespace {

std::set<std::string> FlagsThatMayDiffer() {
  std::set<std::string> names = {"occupied_threshold", "refine"};
  for (const FlagGroup& group : BackendFlagGroups()) {
    names.insert(group.flags.begin(), group.flags.end());
  }
  return names;
}

// The flags of SLAM are those of the session; those of its log are over.
void TakeFlagsOf(const session::Session& session) {
  std::set<std::string> own;
  for (const FlagGroup& group : SlamFlagGroups())
    own.insert(group.flags.begin(), group.flags.end());
  const std::set<std::string> may_differ = FlagsThatMayDiffer();
  for (const auto& [name, value] : session.info.flags) {
    if (!own.contains(name)) continue;
    const auto info = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
    if (info.current_value == value) continue;
    if (info.is_default) {
      gflags::SetCommandLineOption(name.c_str(), value.c_str());
    } else if (!may_differ.contains(name)) {
      throw std::runtime_error("--" + name + ": expected that of the session, " + value +
                               ", or none, found " + info.current_value);
    }
  }
}

Json Identify(const std::string& path) {
  const FileIdentity identity = IdentifyFile(path);
  return {{"sha256", identity.sha256}, {"bytes", identity.bytes}};
}

void Run() {
  if (FLAGS_session.empty()) throw std::runtime_error("--session=FILE is missing");
  if (FLAGS_closures.empty()) throw std::runtime_error("--closures=FILE is missing");
  if (FLAGS_output_dir.empty()) throw std::runtime_error("--output_dir=DIR is missing");
  session::Session session = session::ReadSession(OpenInput(FLAGS_session).get(), FLAGS_session);
  TakeFlagsOf(session);
  SlamRun slam;
  slam.Load(session, FLAGS_session);
  const std::vector<ClosureRow> rows =
      ReadClosureRows(*OpenInput(FLAGS_closures), FLAGS_closures, slam.gmapping().nodes());
  const Json input = {{"session", Identify(FLAGS_session)}, {"closures", Identify(FLAGS_closures)}};
  OutputFiles files(FLAGS_output_dir);
  const Json edits = ApplyClosureRows(rows, FLAGS_closures, &slam.gmapping());
  ThrowIfInterrupted();
  if (!FLAGS_save_session.empty()) session.state = session::SaveState(slam.gmapping());
  slam.FinishEdited(input, edits, FLAGS_refine_scans ? FLAGS_refine : 0, &files);
  files.Commit();
  if (!FLAGS_save_session.empty()) SessionSaver(FLAGS_save_session, 1.0).WriteLast(session);
  std::cout << "by hand: " << edits["accepted"] << " closures accepted, " << edits["rejected"]
            << " rejected, " << edits["added"] << " added; " << edits["unchanged"]
            << " rows as they were; results in " << FLAGS_output_dir << '\n';
}

FlagGroups AllFlagGroups() {
  const FlagGroups output = {
      {"output",
       "Input and output",
       {"session", "closures", "output_dir", "save_session", "refine_scans"}}};
  return Join({output, SlamFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "makes the results of a run anew, with loop closures that were accepted, rejected or added "
      "by "
      "hand.\n"
      "Usage: edit_closures --session=FILE --closures=FILE --output_dir=DIR [--save_session=FILE]\n"
      "Other flags are those of the session; those of the back end and of the map may be given "
      "anew.",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
