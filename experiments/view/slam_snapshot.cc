// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/slam_snapshot.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "backend/graph/pose_graph_sink.h"
#include "frontend/particle_filter/resampling.h"

namespace gmapping_spa::view {
namespace {

constexpr int kTailPoses = 12;

using frontend::ImprovedGmapping;

backend::Trajectory NodesOf(const backend::PoseGraph& graph) {
  backend::Trajectory nodes;
  nodes.reserve(graph.nodes.size());
  for (const backend::Node& node : graph.nodes) nodes.push_back({node.stamp_s, node.world_T_node});
  return nodes;
}

void AddParticles(const particle_filter::ParticleFilter& filter, Snapshot* snapshot) {
  std::vector<double> log_weights;
  for (const auto& particle : filter.particles()) log_weights.push_back(particle.log_weight);
  const std::vector<double> weights = particle_filter::NormalizedWeights(log_weights, 1.0);
  for (int i = 0; i < std::ssize(weights); ++i) {
    snapshot->particles.push_back(
        {filter.particles()[i].world_T_robot, weights[i], filter.LatestPoses(i, kTailPoses)});
  }
  snapshot->best_particle = filter.BestParticle();
}

void AddHealth(const frontend::Health& health, Snapshot* snapshot) {
  snapshot->health = {health.findings(), health.stretches()};
}

}  // namespace

backend::Trajectory ByTime(backend::Trajectory trajectory) {
  std::stable_sort(trajectory.begin(), trajectory.end(),
                   [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
  return trajectory;
}

Figures FiguresOf(const ImprovedGmapping& gmapping, double stamp_s,
                  const backend::SE2& world_T_robot) {
  Figures figures;
  figures.stamp_s = stamp_s;
  figures.scans = gmapping.counts().scans;
  figures.updates = gmapping.counts().updates;
  figures.world_T_robot = world_T_robot;
  if (figures.updates > 1) {
    figures.effective_particles = gmapping.latest_update().effective_sample_size;
  }
  if (gmapping.graph_thread().latest_cost()) figures.cost = *gmapping.graph_thread().latest_cost();
  const loop_closure::LoopCloser& closer = gmapping.loop_closer();
  figures.accepted_closures = std::ssize(closer.closures());
  figures.refused_closures = std::ssize(closer.records()) - figures.accepted_closures;
  return figures;
}

Snapshot SnapshotOf(const ImprovedGmapping& gmapping, const sensor::LaserScan& scan,
                    const ScanResult& result) {
  Snapshot snapshot;
  snapshot.figures = FiguresOf(gmapping, scan.stamp_s, result.world_T_robot);
  snapshot.lost = result.lost;
  snapshot.ambiguous = result.ambiguous;
  snapshot.placed = gmapping.IsPlaced();
  snapshot.scan = scan;
  AddParticles(gmapping.filter(), &snapshot);
  AddHealth(gmapping.health(), &snapshot);
  snapshot.grid = gmapping.CurrentMap();
  return snapshot;
}

std::shared_ptr<const GraphSnapshot> GraphOf(const ImprovedGmapping& gmapping) {
  backend::PoseGraphRecorder recorder;
  gmapping.EmitGraph(&recorder);
  return std::make_shared<const GraphSnapshot>(
      GraphSnapshot{NodesOf(recorder.graph()), gmapping.loop_closer().records()});
}

Snapshot SnapshotOf(const ImprovedGmapping& gmapping, const frontend::SlamResult& result) {
  Snapshot snapshot;
  snapshot.phase = Phase::kFinished;
  snapshot.trajectory = ByTime(result.trajectory);
  const backend::StampedPose& last = snapshot.trajectory.back();
  snapshot.figures = FiguresOf(gmapping, last.stamp_s, last.world_T_robot);
  AddHealth(gmapping.health(), &snapshot);
  snapshot.graph = std::make_shared<const GraphSnapshot>(
      GraphSnapshot{NodesOf(result.graph), gmapping.loop_closer().records()});
  snapshot.grid = result.map;
  return snapshot;
}

}  // namespace gmapping_spa::view
