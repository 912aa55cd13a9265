// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/run_record.h"

#include <gflags/gflags.h>
#include <sys/resource.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "experiments/apps/app.h"
#include "experiments/apps/closure_table.h"
#include "experiments/apps/result_flags.h"
#include "experiments/apps/version.h"

namespace gmapping_spa::apps {
namespace {

Json FlagValue(const gflags::CommandLineFlagInfo& flag) {
  if (flag.type == "bool") return flag.current_value == "true";
  if (flag.type == "string") return flag.current_value;
  const Json number = Json::parse(flag.current_value, nullptr, /*allow_exceptions=*/false);
  return number.is_number() ? number : Json(flag.current_value);  // nan and inf
}

Json FlagValues() {
  Json json;
  for (const std::string& name : ResultFlags()) {
    json[name] = FlagValue(gflags::GetCommandLineFlagInfoOrDie(name.c_str()));
  }
  return json;
}

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Json MakeRunRecord(const Json& input, const frontend::ImprovedGmapping& gmapping,
                   const map::TrinaryMap& map, const Json& health, const Stopwatch& stopwatch) {
  std::string threads;
  gflags::GetCommandLineOption("threads", &threads);
  const frontend::ImprovedGmapping::Counts& counts = gmapping.counts();
  const frontend::GraphThread::Counts& graph = gmapping.graph_thread().counts();
  const particle_filter::ParticleFilter::Times& filter_times = gmapping.filter().times();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  Json json = {
      {"versions",
       {{"gmapping_spa", ReleaseVersion()},
        {"commit", Commit()},
        {"compiler", __VERSION__},
        {"eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
                      "." + std::to_string(EIGEN_MINOR_VERSION)}}},
      {"flags", FlagValues()},
      {"flag_files", FlagFiles()},
      {"flag_overrides", FlagOverrides()},
      {"input", input},
      {"counts",
       {{"scans", counts.scans},
        {"updates", counts.updates},
        {"resamplings", counts.resamplings},
        {"failed_matches", counts.failed_matches},
        {"corrections", counts.corrections},
        {"searched_scans", counts.searched},
        {"pieces", counts.pieces}}},
      {"sweep_duration_s", gmapping.sweep_s()},
      {"loop_closures", CountClosures(gmapping.loop_closer().records())},
      {"graph_thread",
       {{"started", graph.started},
        {"taken", graph.taken},
        {"failed", graph.failed},
        {"late", graph.late}}},
      {"health", health},
      {"map", {{"width", map.width}, {"height", map.height}, {"resolution_m", map.resolution_m}}},
      {"resources",
       {{"threads", std::stoi(threads)},
        {"user_s", Seconds(usage.ru_utime)},
        {"system_s", Seconds(usage.ru_stime)},
        {"peak_memory_mb", static_cast<double>(usage.ru_maxrss) / 1024.0},
        {"matching_s", filter_times.matching_s},
        {"registration_s", filter_times.registration_s},
        {"resampling_s", filter_times.resampling_s},
        {"correction_s", filter_times.correction_s}}}};
  Json& rejected = json["loop_closures"]["rejected_by_backend"] = Json::array();
  for (const auto& [i, j, weight] : gmapping.graph_thread().rejected_closures()) {
    rejected.push_back({{"old_node", i}, {"node", j}, {"weight", weight}});
  }
  json["resources"].update(stopwatch.laps());
  return json;
}

Json MapSessionRecord(const frontend::MapSession& session, std::int64_t scans, std::size_t poses) {
  Json found = Json::array();
  for (const frontend::MapSession::Found& one : session.found()) {
    found.push_back({{"stamp_s", one.stamp_s}, {"after_s", one.after_s}});
  }
  return {{"known_scans", session.scans()},
          {"known_nodes", session.nodes()},
          {"map_is_fixed", session.is_fixed()},
          {"found", found},
          {"is_looked_for_at_end", session.searches()},
          {"scans_of_unknown_pose", scans - static_cast<std::int64_t>(poses)}};
}

}  // namespace gmapping_spa::apps
