// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/node_slam.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "backend/graph/pose_graph_sink.h"
#include "experiments/apps/health_record.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/session_flags.h"
#include "experiments/apps/slam_flags.h"
#include "experiments/ros/node_flags.h"
#include "frontend/map/map_building.h"
#include "frontend/particle_filter/resampling.h"

namespace gmapping_spa::ros {

using backend::SE2;

namespace {

constexpr const char* kLog = "live";  // in a session

void AddMap(const map::TrinaryMap& map, const SE2& map_T_world, Snapshot* snapshot) {
  snapshot->width = map.width;
  snapshot->height = map.height;
  snapshot->resolution_m = map.resolution_m;
  snapshot->map_T_cells = Planar(map_T_world * SE2{map.origin_x_m, map.origin_y_m, 0.0});
  snapshot->cells.reserve(map.cells.size());
  for (const map::CellState cell : map.cells) {
    snapshot->cells.push_back(cell == map::CellState::kUnknown ? -1
                              : cell == map::CellState::kFree  ? 0
                                                               : 100);
  }
}

// What lies where the robot is not known to be may lie anywhere.
void AddGraph(const frontend::ImprovedGmapping& gmapping, const SE2& map_T_world,
              Snapshot* snapshot) {
  backend::PoseGraphRecorder recorder;
  gmapping.EmitGraph(&recorder);
  const int nodes = gmapping.IsPlaced() ? gmapping.nodes() : gmapping.session()->nodes();
  std::map<std::int64_t, PlanarPose> pose_of;
  for (const backend::Node& node : recorder.graph().nodes) {
    if (node.id >= nodes) continue;
    pose_of[node.id] = Planar(map_T_world * node.world_T_node);
    snapshot->map_T_nodes.push_back(pose_of[node.id]);
  }
  for (const backend::Edge& edge : recorder.graph().edges) {
    if (edge.kind != backend::EdgeKind::kLoopClosure) continue;
    if (edge.i >= nodes || edge.j >= nodes) continue;
    snapshot->closures.emplace_back(pose_of.at(edge.i), pose_of.at(edge.j));
  }
}

const map::OccupancyGrid& MapToShow(const frontend::ImprovedGmapping& gmapping) {
  const auto& session = gmapping.session();
  return session && (session->is_fixed() || !gmapping.IsPlaced()) ? session->known().map
                                                                  : gmapping.CurrentMap();
}

}  // namespace

double EntropyOfWeights(const std::vector<double>& log_weights, double gain) {
  double entropy = 0.0;
  for (const double weight : particle_filter::NormalizedWeights(log_weights, gain)) {
    if (weight > 0.0) entropy -= weight * std::log(weight);
  }
  return entropy;
}

NodeSlam::NodeSlam(double map_update_interval_s, std::optional<double> minimum_score)
    : map_update_interval_s_(map_update_interval_s), minimum_score_(minimum_score) {
  const std::string folder = OutputFolderFromFlags();
  if (!folder.empty()) apps::OutputFiles fails_before_the_work_and_not_after(folder);
  MakeRun();
}

void NodeSlam::MakeRun() {
  run_ = std::make_unique<apps::SlamRun>();
  apps::BeginAsFlagsSay(run_.get());
  saver_ = apps::MakeSessionSaver(run_.get());
}

std::optional<SE2> NodeSlam::AddScan(const sensor::LaserScan& scan) {
  if (minimum_score_ && run_->counts().scans == 0) {
    // A mean here, a sum there: only now it is known of how many beams.
    const double mean = *minimum_score_ / static_cast<double>(scan.beams.size());
    gflags::SetCommandLineOption("match_min_score", std::to_string(mean).c_str());
    MakeRun();
  }
  run_->AddScan(scan);
  if (saver_ && saver_->IsDue()) saver_->WriteCheckpoint(run_->MakeSession(kLog));
  stamp_s_ = scan.stamp_s;
  if (!run_->gmapping().IsPlaced()) return std::nullopt;
  return run_->gmapping().CurrentPose();
}

std::optional<Snapshot> NodeSlam::DueSnapshot(const SE2& map_T_world) {
  const frontend::ImprovedGmapping& gmapping = run_->gmapping();
  const std::int64_t changes = gmapping.counts().updates + gmapping.counts().corrections;
  if (changes == shown_changes_) return std::nullopt;
  if (shown_s_ && stamp_s_ < *shown_s_ + map_update_interval_s_) return std::nullopt;
  const SlamOptions options = apps::SlamOptionsFromFlags();
  Snapshot snapshot;
  snapshot.stamp_s = stamp_s_;
  AddMap(map::BuildTrinaryMap(MapToShow(gmapping), options.occupied_threshold), map_T_world,
         &snapshot);
  if (snapshot.cells.empty()) return std::nullopt;
  AddGraph(gmapping, map_T_world, &snapshot);
  std::vector<double> log_weights;
  for (const auto& particle : gmapping.filter().particles()) {
    log_weights.push_back(particle.log_weight);
  }
  snapshot.entropy =
      EntropyOfWeights(log_weights, 1.0 / (options.obs_sigma_gain * options.particles));
  shown_s_ = stamp_s_;
  shown_changes_ = changes;
  return snapshot;
}

void NodeSlam::SaveSession() {
  if (!saver_) throw std::runtime_error("~save_session: expected the file for the session");
  if (run_->counts().scans == 0) throw std::runtime_error("there was no scan yet");
  saver_->WriteLast(run_->MakeSession(kLog));
}

void NodeSlam::Finish(const sensor::LogCounts& counts, const std::function<apps::Json()>& input) {
  if (saver_ && run_->counts().scans > 0) SaveSession();
  const std::string folder = OutputFolderFromFlags();
  if (folder.empty() || run_->counts().scans == 0) {
    apps::WarnOf(counts);
    run_->gmapping().health().LogSummary();
    return;
  }
  apps::OutputFiles files(folder);
  run_->Finish(input, counts, &files);
  files.Commit();
}

}  // namespace gmapping_spa::ros
