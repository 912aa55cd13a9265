// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/slam_run.h"

#include <glog/logging.h>

#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "backend/out_of_memory.h"
#include "backend/text.h"
#include "experiments/apps/app.h"
#include "experiments/apps/backend_flags.h"
#include "experiments/apps/closure_table.h"
#include "experiments/apps/health_record.h"
#include "experiments/apps/localization_table.h"
#include "experiments/apps/result_files.h"
#include "experiments/apps/result_flags.h"
#include "experiments/apps/slam_flags.h"
#include "experiments/apps/version.h"
#include "frontend/map/map_building.h"
#include "frontend/session/state.h"
#include "frontend/slam_parts.h"

namespace gmapping_spa::apps {

SlamRun::SlamRun() : SlamRun(SlamOptionsFromFlags()) {}

SlamRun::SlamRun(const SlamOptions& options)
    : occupied_threshold_(options.occupied_threshold),
      is_async_(options.graph_thread == SlamOptions::GraphThread::kAsync),
      optimizer_(LoadOptimizerFromFlags()),
      gmapping_(frontend::GmappingOptions(options), frontend::MakeScanMatcher(options),
                frontend::BindOptimizer(options, optimizer_)) {
  gmapping_.StopWaitingWhen([] { return ReceivedSignal() != 0; });
}

void SlamRun::LoadBy(LoadFunction* load, const session::Session& session, const std::string& name) {
  try {
    load(session.state, &gmapping_);
  } catch (const std::exception& error) {
    throw std::runtime_error(name + ": expected the state of a run with these flags, found one " +
                             "that does not fit: " + error.what());
  }
}

void SlamRun::Load(const session::Session& session, const std::string& name) {
  LoadBy(session::LoadState, session, name);
}

void SlamRun::GoOnInMapOf(const session::Session& session, const std::string& name,
                          frontend::MapSession::Use use) {
  CheckResultFlag("resolution_m", session.info.flags, name);
  // The back end may be another one: the state of the one before is not asked for.
  LoadBy(session::LoadKnown, session, name);
  if (counts().updates == 0) throw std::runtime_error(name + ": expected a map, found no scan");
  gmapping_.BeginSession(use);
}

std::string SlamRun::WordsOnLocalization() const {
  const std::optional<frontend::MapSession>& session = gmapping_.session();
  if (!session) return "";
  if (session->found().empty()) return "; not found in the old map";
  std::string words = "; found in the old map after " +
                      backend::FixedText(session->found().front().after_s, 1) + " s";
  if (session->searches()) words += ", lost in the end";
  return words;
}

void SlamRun::Resume(const session::Session& session, const std::string& name) {
  CheckResultFlags(session.info.flags, name);
  gmapping_.KeepStateOf(optimizer_);
  Load(session, name);
  stopwatch_.Add(session.info.processing_s);
  session_name_ = name;
  resumed_scans_ = counts().scans;
}

void SlamRun::CheckThatSessionEnded() const {
  if (!CatchesUp()) return;
  throw std::runtime_error(session_name_ + ": expected a log with the " +
                           std::to_string(resumed_scans_) + " scans of its run, found " +
                           std::to_string(given_scans_));
}

void SlamRun::PrepareToSave() {
  gmapping_.KeepStateOf(optimizer_);
  LOG_IF(WARNING, is_async_) << "with --graph_thread=async a resumed run may end with other bytes: "
                                "it depends on the speed of the machine";
  LOG_IF(WARNING, !is_async_ && !optimizer_->State())
      << "the back end cannot save what it keeps between calls, or runs in another process: a "
         "resumed run may end with other bytes";
}

session::Session SlamRun::MakeSession(const std::string& log) const {
  return {{.program = ReleaseVersion(),
           .log = std::filesystem::path(log).filename().string(),
           .scans = counts().scans,
           .processing_s = stopwatch_.elapsed_s(),
           .flags = ResultFlagValues()},
          session::SaveState(gmapping_)};
}

void SlamRun::AddScan(const sensor::LaserScan& scan) {
  if (CatchesUp()) {
    if (!gmapping_.HasTaken(given_scans_, scan)) {
      throw std::runtime_error(session_name_ +
                               ": expected the log of its run, found another scan " +
                               std::to_string(given_scans_ + 1));
    }
    ++given_scans_;
    return;
  }
  backend::WithMemory("at scan " + std::to_string(counts().scans + 1) + " with the maps of " +
                          std::to_string(gmapping_.filter().particles().size()) + " particles",
                      [&] {
                        const ScanResult result = gmapping_.AddScan(scan);
                        if (observer_) observer_->AfterScan(gmapping_, scan, result);
                      });
}

bool SlamRun::Finish(const std::function<Json()>& input, const sensor::LogCounts& log_counts,
                     OutputFiles* files) {
  return backend::WithMemory(
      "while making the results of " + std::to_string(counts().scans) + " scans",
      [&] { return WriteResults(input, log_counts, files); });
}

// Where in the map the robot is not known to have been, no pose is told.
backend::Trajectory SlamRun::OfThisLog(const frontend::SlamResult& result) const {
  const std::optional<frontend::MapSession>& session = gmapping_.session();
  if (!session) return result.trajectory;
  backend::Trajectory poses;
  for (std::size_t row = session->scans(); row < result.trajectory.size(); ++row) {
    if (result.is_placed[row]) poses.push_back(result.trajectory[row]);
  }
  return poses;
}

bool SlamRun::WriteResults(const std::function<Json()>& input, const sensor::LogCounts& log_counts,
                           OutputFiles* files) {
  stopwatch_.Lap("processing_s");
  const std::int64_t late = gmapping_.graph_thread().counts().late;
  if (observer_) observer_->BeforeFinish();
  int signal = ReceivedSignal();
  const frontend::SlamResult estimate = signal == 0 ? gmapping_.Finish() : gmapping_.FinishEarly();
  // A signal during the final optimization may have cut it short.
  if (gmapping_.graph_thread().counts().late > late) signal = ReceivedSignal();
  if (observer_) observer_->AfterFinish(gmapping_, estimate);
  Json record = WriteEstimate(estimate, input, log_counts, files);
  if (resumed_scans_ > 0) record["resources"]["resumed_after_scans"] = resumed_scans_;
  if (signal != 0) record["interrupted"] = {{"signal", signal}, {"scans", counts().scans}};
  files->Write("run.json", [&](std::ostream& out) { out << TextOf(record) << '\n'; });
  WarnOf(log_counts);
  gmapping_.health().LogSummary();
  return signal == 0;
}

void SlamRun::FinishEdited(const Json& input, const Json& edits, int refine, OutputFiles* files) {
  stopwatch_.Lap("processing_s");
  const frontend::SlamResult estimate = gmapping_.FinishEdited(refine);
  ThrowIfInterrupted();
  Json record = WriteEstimate(
      estimate, [&] { return input; }, {}, files);
  record["edits"] = edits;
  files->Write("run.json", [&](std::ostream& out) { out << TextOf(record) << '\n'; });
  gmapping_.health().LogSummary();
}

Json SlamRun::WriteEstimate(const frontend::SlamResult& estimate,
                            const std::function<Json()>& input, const sensor::LogCounts& log_counts,
                            OutputFiles* files) {
  stopwatch_.Lap("finish_s");
  const map::TrinaryMap map = map::BuildTrinaryMap(estimate.map, occupied_threshold_);
  if (map.cells.empty()) throw std::runtime_error("no scan saw anything: the map would be empty");
  const backend::Trajectory trajectory = OfThisLog(estimate);
  WriteResultFiles(trajectory, estimate.graph, map, gmapping_.health().stretches(), files);
  files->Write("loop_closures.csv", [&](std::ostream& out) {
    WriteClosures(gmapping_.loop_closer().records(), estimate.graph.nodes, out);
  });
  if (gmapping_.session() && gmapping_.session()->is_fixed()) {
    const std::vector<LocalizedScan> scans = LocalizedScans(gmapping_, estimate, optimizer_.get());
    files->Write("localization.csv", [&](std::ostream& out) { WriteLocalization(scans, out); });
  }
  stopwatch_.Lap("writing_s");
  const Json health = HealthRecord(gmapping_.health(), log_counts);
  Json record = MakeRunRecord(input(), gmapping_, map, health, stopwatch_);
  if (gmapping_.session()) {
    record["session"] = MapSessionRecord(*gmapping_.session(), counts().scans, trajectory.size());
    LOG_IF(WARNING, trajectory.empty()) << "the robot was not found in the map of the session: no "
                                           "pose is told";
  }
  return record;
}

}  // namespace gmapping_spa::apps
