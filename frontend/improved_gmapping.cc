#include "frontend/improved_gmapping.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gmapping_spa::frontend {

using backend::SE2;
using particle_filter::ParticleFilter;
using particle_filter::TrajectoryTree;

ImprovedGmapping::ImprovedGmapping(const Options& options,
                                   std::shared_ptr<const scan_matching::ScanMatcher> matcher,
                                   backend::OptimizationThread::OptimizeFunction optimize)
    : options_(options),
      filter_(options.filter, std::move(matcher)),
      control_(options.control, &health_),
      loop_closer_(options.loop_closer),
      graph_thread_(options.graph_thread, std::move(optimize)),
      area_(options.filter.grid.resolution_m) {}

void ImprovedGmapping::AddScan(const sensor::LaserScan& scan) {
  // Step 1: the control input.
  const ScanMotion motion = control_.Advance(scan);
  const SE2& u = motion.motion;
  // What one scan does not decide becomes a step of its own, for particles to take apart.
  const bool ambiguous = !motion.alternatives.empty();
  if (ambiguous && !scan_poses_.latest_is_update()) {
    scan_poses_.MakeUpdate();
    UpdateFilter(archive_.Get(archive_.size() - 1),
                 {{Between(odom_T_last_update_, odom_T_scan_)}});
  }
  counts_.searched += motion.searched ? 1 : 0;
  odom_T_scan_ = odom_T_scan_ * u;
  area_.Extend(scan, odom_T_scan_);
  archive_.Add(scan);
  ++counts_.scans;

  // Steps 4' and 6: what the graph thread has found out corrects the particles.
  if (const auto optimized = graph_thread_.Advance()) TakeOver(*optimized);

  const bool is_update = UpdateIsDue(u) || ambiguous;
  // In units of what triggers an update; the 1e-9 spreads by number of scans if nothing moved.
  const double amount = u.translation().norm() / std::max(options_.linear_update_m, 1e-3) +
                        std::abs(u.theta) / std::max(options_.angular_update_rad, 1e-3) + 1e-9;
  scan_poses_.Add(scan, odom_T_scan_, amount, is_update);
  if (!is_update) return;

  // Steps 2 to 5 and 7 to 10: scan matching, sampling, weights, maps and resampling.
  if (ambiguous) {
    UpdateFilter(scan, motion.alternatives);
  } else {
    UpdateFilter(scan, {{Between(odom_T_last_update_, odom_T_scan_)}});
  }

  // Step 3': the pose graph with its closed-loop constraints goes to the graph thread.
  if (options_.close_loops) CloseLoops();
  StartOptimization();
}

bool ImprovedGmapping::UpdateIsDue(const SE2& u) {
  linear_since_update_m_ += u.translation().norm();
  angular_since_update_rad_ += std::abs(u.theta);
  return counts_.updates == 0 || linear_since_update_m_ >= options_.linear_update_m ||
         angular_since_update_rad_ >= options_.angular_update_rad;
}

void ImprovedGmapping::UpdateFilter(const sensor::LaserScan& scan,
                                    const std::vector<ParticleFilter::Control>& controls) {
  if (counts_.updates == 0) {
    filter_.Start(scan, SE2{});
  } else {
    for (const particle_filter::Particle& particle : filter_.particles()) {
      area_.Extend(scan, particle.world_T_robot * controls.front().motion);
    }
    const ParticleFilter::Update update = filter_.Advance(scan, controls);
    counts_.resamplings += update.resampled ? 1 : 0;
    counts_.failed_matches += update.failed_matches;
  }
  node_scans_.push_back(archive_.size() - 1);
  ++counts_.updates;
  ++updates_since_optimization_;
  odom_T_last_update_ = odom_T_scan_;
  linear_since_update_m_ = 0.0;
  angular_since_update_rad_ = 0.0;
}

void ImprovedGmapping::CloseLoops() {
  backend::PoseGraphRecorder path;
  EmitPath(&path);
  const int closed = loop_closer_.Update(backend::PosesOf(path.graph()),
                                         [this](int node) { return ScanOfNode(node); });
  if (closed > 0) closure_waits_ = true;
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
  graph_thread_.Start(recorder.graph());
}

// Eq. (14). Poses that came in since the optimization started move with its last one.
void ImprovedGmapping::TakeOver(const backend::PoseGraph& optimized) {
  const particle_filter::PathCorrection correction{world_T_nodes_before_,
                                                   backend::PosesOf(optimized)};
  if (correction.after == correction.before) return;
  ++counts_.corrections;
  if (options_.correction == Correction::kPose) {
    filter_.CorrectCurrentPoses(correction);
  } else {
    filter_.CorrectHistories(correction, [this](int node) { return ScanOfNode(node); });
  }
}

void ImprovedGmapping::EmitPath(backend::PoseGraphSink* sink) const {
  for (const TrajectoryTree::Vertex& vertex : filter_.Path(filter_.BestParticle())) {
    sink->AddNode({.id = vertex.step,
                   .stamp_s = archive_.StampOf(node_scans_[vertex.step]),
                   .world_T_node = vertex.world_T_robot});
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

Estimate ImprovedGmapping::CurrentEstimate() const {
  backend::PoseGraphRecorder recorder;
  EmitGraph(&recorder);
  return {recorder.graph(), scan_poses_.Fill(backend::PosesOf(recorder.graph())),
          BestParticle().map};
}

Estimate ImprovedGmapping::Finish() {
  if (const auto optimized = graph_thread_.Finish()) TakeOver(*optimized);
  if (!options_.make_final_round) return CurrentEstimate();
  FinalRound final_round(
      options_.final_round,
      {.scans = &archive_,
       .node_scans = &node_scans_,
       .scan_poses = &scan_poses_,
       .grid = options_.filter.grid,
       .registration = options_.filter.registration,
       .loop_closer = options_.close_loops ? &loop_closer_ : nullptr,
       .optimize = [this](const backend::PoseGraph& graph) { return graph_thread_.Run(graph); }});
  backend::PoseGraphRecorder path;
  EmitPath(&path);
  return final_round.Finish(path.graph());
}

}  // namespace gmapping_spa::frontend
