// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/improved_gmapping.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "frontend/closure_findings.h"
#include "frontend/scan_density.h"
#include "frontend/sensor/deskew.h"

namespace gmapping_spa::frontend {

using backend::SE2;
using particle_filter::ParticleFilter;
using particle_filter::TrajectoryTree;

ImprovedGmapping::ImprovedGmapping(const Options& options,
                                   std::shared_ptr<const scan_matching::ScanMatcher> matcher,
                                   GraphThread::OptimizeFunction optimize)
    : options_(options),
      filter_(options.filter, std::move(matcher)),
      control_(options.control, &health_),
      loop_closer_(options.loop_closer),
      graph_thread_(options.graph_thread, &health_, std::move(optimize)),
      area_(options.filter.grid.resolution_m) {}

ScanResult ImprovedGmapping::AddScan(const sensor::LaserScan& measured) {
  const Counts before = counts_;
  ScanResult result;
  if (session_) {
    Process(session_->Numbered(measured), &result);
  } else {
    Process(measured, &result);
  }
  result.updated = counts_.updates > before.updates;
  result.corrected = counts_.corrections > before.corrections;
  result.world_T_robot = CurrentPose();
  return result;
}

void ImprovedGmapping::Process(const sensor::LaserScan& measured, ScanResult* result) {
  // Step 1: the control input.
  ScanMotion motion = control_.AddScan(measured);
  if (BeginsSession()) motion.new_piece_scans = 1;
  const SE2& u = motion.motion;
  // What one scan does not decide becomes a step of its own, for particles to take apart.
  const bool ambiguous = !motion.alternatives.empty();
  result->ambiguous = ambiguous;
  result->lost = !motion.matched;
  if (ambiguous && !scan_poses_.latest_is_update() && !is_lost_.back()) {
    scan_poses_.MakeUpdate();
    UpdateFilter(archive_.Get(archive_.size() - 1), {ControlSinceUpdate()});
  }
  counts_.searched += motion.searched ? 1 : 0;
  const SE2 odom_T_before = odom_T_scan_;
  odom_T_scan_ = odom_T_scan_ * u;
  if (options_.filter.motion.noise_at_each_scan) increments_since_update_.push_back(u);
  noise_since_update_ = std::max(noise_since_update_, motion.noise);
  archive_.set_sweep_s(control_.sweep_s());
  const sensor::LaserScan scan = sensor::Deskew(measured, control_.sweep_s() * motion.velocity);
  // In the frame of the map: odometry alone may drift much farther.
  area_.Extend(scan, node_scans_.empty() ? odom_T_scan_ : CurrentPose());
  archive_.Add(measured, motion.velocity);
  is_lost_.push_back(!motion.matched);
  ++counts_.scans;

  // Steps 4' and 6: what the graph thread has found out corrects the particles.
  if (const auto optimized = graph_thread_.TakeIfDue(scan.stamp_s)) ApplyOptimizedGraph(*optimized);

  const bool is_update = (UpdateIsDue(u, UpdateDensity(scan)) || ambiguous) && motion.matched;
  // In units of what triggers an update; the 1e-9 spreads by number of scans if nothing moved.
  const double amount = u.translation().norm() / std::max(options_.linear_update_m, 1e-3) +
                        std::abs(u.theta) / std::max(options_.angular_update_rad, 1e-3) + 1e-9;
  if (motion.new_piece_scans > 0) {
    scan_poses_.Add(scan, odom_T_scan_, amount, false);
    BeginPiece(motion.new_piece_scans, motion.wheels_told_way_to_piece);
    if (session_) LookForRobot(scan, {});
    return;
  }
  scan_poses_.Add(scan, odom_T_scan_, amount, is_update);
  if (session_ && motion.matched) LookForRobot(scan, u);
  if (!is_update) return;

  // Steps 2 to 5 and 7 to 10: scan matching, sampling, weights, maps and resampling.
  if (ambiguous) {
    std::vector<ParticleFilter::Control> controls = motion.alternatives;
    // Not from the last update where the scan before it was lost.
    const SE2 up_to_here = Between(odom_T_last_update_, odom_T_before);
    for (ParticleFilter::Control& control : controls) {
      control.increments = increments_since_update_;
      if (!control.increments.empty()) control.increments.back() = control.motion;
      control.motion = up_to_here * control.motion;
    }
    UpdateFilter(scan, controls);
  } else {
    UpdateFilter(scan, {ControlSinceUpdate()});
  }

  // Step 3': the pose graph with its closed-loop constraints goes to the graph thread.
  if (options_.close_loops) result->closed_loop = CloseLoops();
  StartOptimization();
}

bool ImprovedGmapping::UpdateIsDue(const SE2& u, double density) {
  linear_since_update_m_ += u.translation().norm();
  angular_since_update_rad_ += std::abs(u.theta);
  return node_scans_.empty() || linear_since_update_m_ >= density * options_.linear_update_m ||
         angular_since_update_rad_ >= density * options_.angular_update_rad;
}

ParticleFilter::Control ImprovedGmapping::ControlSinceUpdate() const {
  return {.motion = Between(odom_T_last_update_, odom_T_scan_),
          .noise = noise_since_update_,
          .increments = increments_since_update_};
}

void ImprovedGmapping::UpdateFilter(const sensor::LaserScan& scan,
                                    const std::vector<ParticleFilter::Control>& controls) {
  if (node_scans_.empty()) {
    if (ParticleFilter::AreAllAlike(options_.filter)) {
      health_.Report("particles_alike", scan.stamp_s,
                     "the flags leave nothing to chance: all particles are copies of one");
    }
    filter_.Start(scan, SE2{});
  } else {
    for (const particle_filter::Particle& particle : filter_.particles()) {
      area_.Extend(scan, particle.world_T_robot * controls.front().motion);
    }
    latest_update_ = filter_.Update(scan, controls);
    counts_.resamplings += latest_update_.resampled ? 1 : 0;
    counts_.failed_matches += latest_update_.failed_matches;
  }
  node_scans_.push_back(archive_.size() - 1);
  ++counts_.updates;
  ++updates_since_optimization_;
  odom_T_last_update_ = odom_T_scan_;
  increments_since_update_.clear();
  noise_since_update_ = 0.0;
  linear_since_update_m_ = 0.0;
  angular_since_update_rad_ = 0.0;
}

bool ImprovedGmapping::CloseLoops() {
  const int closed = loop_closer_.Update(filter_.PosesOfPath(filter_.BestParticle()),
                                         [this](int node) { return ScanOfNode(node); });
  if (closed > 0) closure_waits_ = true;
  return closed > 0;
}

// Every so many poses, and at once after a closure.
void ImprovedGmapping::StartOptimization() {
  if (!closure_waits_ && updates_since_optimization_ < options_.optimize_every) return;
  if (graph_thread_.busy()) return;
  updates_since_optimization_ = 0;
  closure_waits_ = false;
  backend::PoseGraphRecorder recorder;
  EmitGraph(&recorder);
  world_T_nodes_before_ = backend::PosesOf(recorder.graph());
  closures_before_ = loop_closer_.closures();
  backend::PoseGraph graph = recorder.graph();
  loop_closer_.pieces().Arrange(closures_before_, &graph);
  graph_thread_.Start(std::move(graph));
}

// Eq. (14). Poses that came in since the optimization started move with its last one. Pieces that
// it joins move as a whole in any case: until then they lay anywhere.
void ImprovedGmapping::ApplyOptimizedGraph(const backend::PoseGraph& optimized) {
  const particle_filter::PathCorrection correction{world_T_nodes_before_,
                                                   backend::PosesOf(optimized)};
  const int latest = static_cast<int>(node_scans_.size()) - 1;
  std::vector<bool> is_drawn = loop_closer_.pieces().JoinedWith(latest, closures_before_);
  const bool joins = is_drawn != is_drawn_;
  if (correction.after == correction.before && !joins) return;
  ++counts_.corrections;
  if (options_.correction == Correction::kPose && !joins) {
    filter_.CorrectCurrentPoses(correction);
    return;
  }
  if (joins) filter_.ForgetMapHistory();
  is_drawn_ = std::move(is_drawn);
  filter_.CorrectHistories(correction, [this](int node) { return DrawnScanOfNode(node); });
}

void ImprovedGmapping::ReportClosures(const std::vector<SE2>& world_T_nodes) {
  const auto stamp_of_node = [this](int node) { return archive_.StampOf(node_scans_[node]); };
  ReportRejectedClosures(graph_thread_.rejected_closures(), stamp_of_node, &health_);
  ReportUnprovenClosures(loop_closer_.Unproven(world_T_nodes), stamp_of_node, &health_);
}

void ImprovedGmapping::EmitPath(backend::PoseGraphSink* sink) const {
  const int nodes_fixed = session_ && session_->is_fixed() ? session_->nodes() : 0;
  for (const TrajectoryTree::Vertex& vertex : filter_.Path(filter_.BestParticle())) {
    sink->AddNode({.id = vertex.step,
                   .stamp_s = archive_.StampOf(node_scans_[vertex.step]),
                   .world_T_node = vertex.world_T_robot,
                   .fixed = vertex.step < nodes_fixed});
    if (vertex.step == 0) continue;
    sink->AddEdge({.i = vertex.step - 1,
                   .j = vertex.step,
                   .i_T_j = vertex.motion.previous_T_robot,
                   .information = vertex.motion.information,
                   .kind = vertex.motion.matched ? backend::EdgeKind::kScanMatch
                                                 : backend::EdgeKind::kOdometry});
  }
}

void ImprovedGmapping::EmitGraph(backend::PoseGraphSink* sink) const {
  EmitPath(sink);
  for (const backend::Edge& closure : loop_closer_.closures()) sink->AddEdge(closure);
}

const particle_filter::Particle& ImprovedGmapping::BestParticle() const {
  return filter_.particles()[filter_.BestParticle()];
}

SE2 ImprovedGmapping::CurrentPose() const {
  return BestParticle().world_T_robot * Between(odom_T_last_update_, odom_T_scan_);
}

backend::Trajectory ImprovedGmapping::CurrentTrajectory() const {
  return scan_poses_.Fill(filter_.PosesOfPath(filter_.BestParticle()));
}

SlamResult ImprovedGmapping::CurrentResult() const {
  backend::PoseGraphRecorder recorder;
  EmitGraph(&recorder);
  const std::vector<bool> is_drawn = DrawnScans(session_ ? DrawnInTheEnd() : is_drawn_);
  const std::vector<std::size_t> rows = archive_.Rows();
  std::vector<bool> is_placed(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) is_placed[rows[k]] = is_drawn[k];
  return {recorder.graph(), CurrentTrajectory(), CurrentMap(), std::move(is_placed)};
}

SlamResult ImprovedGmapping::FinishEarly() {
  if (const auto optimized = graph_thread_.Finish()) ApplyOptimizedGraph(*optimized);
  JoinPieces();
  ReportPieces(session_ ? DrawnInTheEnd() : is_drawn_);
  ReportClosures(filter_.PosesOfPath(filter_.BestParticle()));
  return CurrentResult();
}

}  // namespace gmapping_spa::frontend
