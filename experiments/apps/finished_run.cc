// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/finished_run.h"

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backend/graph/g2o_io.h"
#include "experiments/apps/closure_rows.h"
#include "experiments/apps/graph_stamps.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/json.h"
#include "experiments/apps/staging_folder.h"
#include "experiments/view/slam_snapshot.h"
#include "frontend/map/map_server_io.h"

namespace gmapping_spa::apps {
namespace {

using view::Figures;

backend::Trajectory ReadNodes(const std::string& path) {
  backend::PoseGraph graph = backend::ReadG2o(*OpenInput(path), path);
  if (!ReadStampsBeside(path, &graph)) {
    throw std::runtime_error(StampsPathOf(path) + ": expected the stamps of the graph beside it");
  }
  backend::Trajectory nodes;
  for (const backend::Node& node : graph.nodes) nodes.push_back({node.stamp_s, node.world_T_node});
  return nodes;
}

std::vector<loop_closure::ClosureRecord> ReadCandidates(const std::string& path,
                                                        std::size_t nodes) {
  std::vector<loop_closure::ClosureRecord> candidates;
  for (const ClosureRow& row : ReadClosureRows(*OpenInput(path), path, static_cast<int>(nodes))) {
    candidates.push_back(row.record);
  }
  return candidates;
}

view::HealthSnapshot HealthOf(const Json& record) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  view::HealthSnapshot health;
  for (const auto& [kind, entry] : record.at("health").items()) {
    if (entry.contains("message")) {
      health.findings[kind] = {.message = entry.at("message"),
                               .first_stamp_s = entry.value("first_s", kUnknown),
                               .last_stamp_s = entry.value("last_s", kUnknown),
                               .count = entry.value("count", std::int64_t{1})};
    }
    for (const Json& stretch : entry.value("stretches", Json::array())) {
      health.stretches[kind].push_back({stretch.at(0), stretch.at(1)});
    }
  }
  return health;
}

// Closures are what a finished run tells over time.
std::vector<Figures> HistoryOf(const view::GraphSnapshot& graph,
                               const backend::Trajectory& trajectory) {
  std::vector<Figures> history;
  const std::size_t step = trajectory.size() / 1000 + 1;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (i % step != 0 && i + 1 != trajectory.size()) continue;
    Figures figures;
    figures.stamp_s = trajectory[i].stamp_s;
    figures.scans = static_cast<std::int64_t>(i) + 1;
    figures.world_T_robot = trajectory[i].world_T_robot;
    for (const loop_closure::ClosureRecord& candidate : graph.candidates) {
      if (graph.nodes.at(candidate.node).stamp_s > figures.stamp_s) continue;
      ++(candidate.verdict == loop_closure::Verdict::kAccepted ? figures.accepted_closures
                                                               : figures.refused_closures);
    }
    history.push_back(figures);
  }
  return history;
}

view::FinishedRun ReadFiles(const std::string& folder) {
  view::FinishedRun run;
  view::Snapshot& snapshot = run.snapshot;
  snapshot.phase = view::Phase::kFinished;
  snapshot.finished_map = map::ReadMap(folder + "/map.yaml");
  const std::string trajectory = folder + "/trajectory.tum", graph = folder + "/graph.g2o",
                    closures = folder + "/loop_closures.csv", record = folder + "/run.json";
  snapshot.trajectory = view::ByTime(backend::ReadTum(*OpenInput(trajectory), trajectory));
  if (snapshot.trajectory.empty()) throw std::runtime_error(trajectory + ": expected a pose");
  view::GraphSnapshot graph_snapshot;
  graph_snapshot.nodes = ReadNodes(graph);
  graph_snapshot.candidates = ReadCandidates(closures, graph_snapshot.nodes.size());
  run.history = HistoryOf(graph_snapshot, snapshot.trajectory);
  const Json json = Json::parse(*OpenInput(record), nullptr, /*allow_exceptions=*/false);
  try {
    snapshot.health = HealthOf(json);
    snapshot.figures.updates = json.at("counts").at("updates");
  } catch (const Json::exception& error) {
    throw std::runtime_error(record + ": expected the record of a run (" + error.what() + ")");
  }
  snapshot.figures.stamp_s = snapshot.trajectory.back().stamp_s;
  snapshot.figures.scans = std::ssize(snapshot.trajectory);
  snapshot.figures.world_T_robot = snapshot.trajectory.back().world_T_robot;
  if (!run.history.empty()) {
    snapshot.figures.accepted_closures = run.history.back().accepted_closures;
    snapshot.figures.refused_closures = run.history.back().refused_closures;
  }
  snapshot.graph = std::make_shared<const view::GraphSnapshot>(std::move(graph_snapshot));
  run.title = {.name = std::filesystem::path(folder).lexically_normal().string(),
               .is_live = false,
               .resolution_m = snapshot.finished_map->resolution_m};
  return run;
}

}  // namespace

view::FinishedRun ReadFinishedRun(const std::string& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error("--view: expected 'live' or a folder with results, found '" + folder +
                             "'");
  }
  CompleteSet(folder);
  return ReadFiles(folder);
}

}  // namespace gmapping_spa::apps
