// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/api/slam.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "backend/graph/pose_graph_sink.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize.h"
#include "frontend/improved_gmapping.h"
#include "frontend/map/map_building.h"
#include "frontend/slam_parts.h"
#include "frontend/slam_result.h"

namespace gmapping_spa {
namespace {

const SlamOptions& Checked(const SlamOptions& options) {
  CheckSlamOptions(options);
  return options;
}

std::shared_ptr<backend::Optimizer> Checked(const SlamOptions& options,
                                            std::shared_ptr<backend::Optimizer> optimizer) {
  if (optimizer == nullptr) throw std::invalid_argument("the optimizer is null");
  backend::CheckOptions(options.optimizer, *optimizer);
  return optimizer;
}

void CheckScan(const sensor::LaserScan& scan) {
  const auto is_finite = [](const sensor::Beam& beam) {
    return std::isfinite(beam.angle_rad) && std::isfinite(beam.range_m);
  };
  const char* const what = !std::isfinite(scan.stamp_s)                         ? "stamp"
                           : scan.has_odometry && !scan.odom_T_robot.IsFinite() ? "odometry"
                           : !scan.robot_T_laser.IsFinite() ? "pose of the laser"
                           : !std::all_of(scan.beams.begin(), scan.beams.end(), is_finite)
                               ? "beam"
                               : nullptr;
  if (what == nullptr) return;
  throw std::invalid_argument(std::string("a scan's ") + what + ": expected finite numbers");
}

}  // namespace

struct Slam::State {
  State(const SlamOptions& options, std::shared_ptr<backend::Optimizer> optimizer)
      : occupied_threshold(options.occupied_threshold),
        gmapping(frontend::GmappingOptions(options), frontend::MakeScanMatcher(options),
                 frontend::BindOptimizer(options, std::move(optimizer))) {}

  void NeedsScan() const {
    if (scans == 0) throw std::logic_error("nothing is known before the first scan");
  }

  double occupied_threshold;
  frontend::ImprovedGmapping gmapping;
  std::int64_t scans = 0;
  std::optional<frontend::SlamResult> finished;
};

Slam::Slam(const SlamOptions& options)
    : Slam(Checked(options), backend::LoadOptimizer(options.backend)) {}

Slam::Slam(const SlamOptions& options, std::shared_ptr<backend::Optimizer> optimizer)
    : state_(std::make_unique<State>(Checked(options), Checked(options, std::move(optimizer)))) {}

Slam::~Slam() = default;
Slam::Slam(Slam&&) noexcept = default;
Slam& Slam::operator=(Slam&&) noexcept = default;

ScanResult Slam::AddScan(const sensor::LaserScan& scan) {
  if (state_->finished) throw std::logic_error("a scan was added after Finish");
  CheckScan(scan);
  sensor::LaserScan numbered = scan;
  numbered.index = state_->scans;
  const ScanResult result = state_->gmapping.AddScan(numbered);
  ++state_->scans;
  return result;
}

void Slam::Finish() {
  state_->NeedsScan();
  if (!state_->finished) state_->finished = state_->gmapping.Finish();
}

backend::SE2 Slam::CurrentPose() const {
  state_->NeedsScan();
  if (state_->finished) return state_->finished->trajectory.back().world_T_robot;
  return state_->gmapping.CurrentPose();
}

map::TrinaryMap Slam::CurrentMap() const {
  state_->NeedsScan();
  return map::BuildTrinaryMap(
      state_->finished ? state_->finished->map : state_->gmapping.CurrentMap(),
      state_->occupied_threshold);
}

backend::PoseGraph Slam::CurrentGraph() const {
  state_->NeedsScan();
  if (state_->finished) return state_->finished->graph;
  backend::PoseGraphRecorder recorder;
  state_->gmapping.EmitGraph(&recorder);
  return recorder.graph();
}

backend::Trajectory Slam::CurrentTrajectory() const {
  state_->NeedsScan();
  if (state_->finished) return state_->finished->trajectory;
  return state_->gmapping.CurrentTrajectory();
}

}  // namespace gmapping_spa
