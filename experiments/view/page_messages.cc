// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/page_messages.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/view/json_values.h"

namespace gmapping_spa::view {
namespace {

using nlohmann::json;

const char* PhaseName(Phase phase) {
  switch (phase) {
    case Phase::kRunning:
      return "running";
    case Phase::kFinishing:
      return "finishing";
    case Phase::kFinished:
      return "finished";
  }
  return "";
}

// In the order of the page's history.js.
json FiguresJson(const Figures& figures) {
  return {Seconds(figures.stamp_s),
          figures.scans,
          figures.updates,
          Millimeters(figures.world_T_robot.x),
          Millimeters(figures.world_T_robot.y),
          Milliradians(figures.world_T_robot.theta),
          Rounded(figures.effective_particles, 1e2),
          Rounded(figures.cost, 1e3),
          Rounded(figures.scans_per_s, 10),
          figures.accepted_closures,
          figures.refused_closures};
}

json ParticleJson(const ParticleSnapshot& particle) {
  json tail = json::array();
  for (const backend::SE2& pose : particle.tail) {
    tail.push_back(Millimeters(pose.x));
    tail.push_back(Millimeters(pose.y));
  }
  return {{"pose", PoseJson(particle.world_T_robot)},
          {"weight", Rounded(particle.weight, 1e3)},
          {"tail", std::move(tail)}};
}

// Where beams ended, x and y in turn, in the world.
json ScanJson(const sensor::LaserScan& scan, const backend::SE2& world_T_robot) {
  const backend::SE2 world_T_laser = world_T_robot * scan.robot_T_laser;
  json points = json::array();
  for (const sensor::Beam& beam : scan.beams) {
    if (beam.status != sensor::BeamStatus::kHit) continue;
    const Eigen::Vector2d point =
        world_T_laser * Eigen::Vector2d(beam.range_m * std::cos(beam.angle_rad),
                                        beam.range_m * std::sin(beam.angle_rad));
    points.push_back(Millimeters(point.x()));
    points.push_back(Millimeters(point.y()));
  }
  return points;
}

json CandidateJson(std::size_t position, const loop_closure::ClosureRecord& record) {
  return {{"position", position},
          {"old_node", record.old_node},
          {"node", record.node},
          {"verdict", loop_closure::VerdictName(record.verdict)},
          {"source", loop_closure::SourceName(record.source)},
          {"path_length_m", Rounded(record.path_length_m, 10)},
          {"distance_m", Millimeters(record.distance_m)},
          {"score", Rounded(record.score, 1e3)},
          {"runner_up_score", Rounded(record.runner_up_score, 1e3)},
          {"overlap", Rounded(record.overlap, 1e3)},
          {"inlier_ratio", Rounded(record.inlier_ratio, 1e3)},
          {"mutual_inlier_ratio", Rounded(record.mutual_inlier_ratio, 1e3)},
          {"mahalanobis_sq", Rounded(record.mahalanobis_sq, 10)},
          {"old_T_node", PoseJson(record.old_T_node)}};
}

}  // namespace

MessagePtr HelloMessage(const std::string& session, const std::vector<RunTitle>& runs) {
  json message = {{"op", "hello"}, {"session", session}, {"runs", json::array()}};
  for (const RunTitle& run : runs) {
    message["runs"].push_back(
        {{"name", run.name}, {"live", run.is_live}, {"resolution_m", run.resolution_m}});
  }
  return Dumped(message);
}

MessagePtr ControlMessage(bool paused) { return Dumped({{"op", "control"}, {"paused", paused}}); }

MessagePtr FrameMessage(int run, const Snapshot& snapshot) {
  json rows = json::array();
  for (const Figures& figures : snapshot.history) rows.push_back(FiguresJson(figures));
  json particles = json::array();
  for (const ParticleSnapshot& p : snapshot.particles) particles.push_back(ParticleJson(p));
  return Dumped({{"op", "frame"},
                 {"run", run},
                 {"phase", PhaseName(snapshot.phase)},
                 {"figures", FiguresJson(snapshot.figures)},
                 {"rows", std::move(rows)},
                 {"lost", snapshot.lost},
                 {"ambiguous", snapshot.ambiguous},
                 {"placed", snapshot.placed},
                 {"particles", std::move(particles)},
                 {"best", snapshot.best_particle},
                 {"scan", ScanJson(snapshot.scan, snapshot.figures.world_T_robot)}});
}

MessagePtr HistoryMessage(int run, const std::vector<Figures>& rows) {
  json array = json::array();
  for (const Figures& figures : rows) array.push_back(FiguresJson(figures));
  return Dumped({{"op", "history"}, {"run", run}, {"rows", std::move(array)}});
}

MessagePtr HealthMessage(int run, const HealthSnapshot& health) {
  json findings = json::array(), stretches = json::object();
  for (const auto& [kind, finding] : health.findings) {
    findings.push_back({{"kind", kind},
                        {"message", finding.message},
                        {"count", finding.count},
                        {"first_s", Seconds(finding.first_stamp_s)},
                        {"last_s", Seconds(finding.last_stamp_s)}});
  }
  for (const auto& [kind, list] : health.stretches) {
    json array = json::array();
    for (const frontend::Stretch& stretch : list) {
      array.push_back({Seconds(stretch.begin_s), Seconds(stretch.end_s)});
    }
    stretches[kind] = std::move(array);
  }
  return Dumped({{"op", "health"},
                 {"run", run},
                 {"findings", std::move(findings)},
                 {"stretches", std::move(stretches)}});
}

MessagePtr PosesMessage(const char* kind, int run, std::size_t from,
                        std::span<const backend::StampedPose> poses) {
  json values = json::array();  // x, y, theta, stamp in turn
  for (const backend::StampedPose& pose : poses) {
    values.push_back(Millimeters(pose.world_T_robot.x));
    values.push_back(Millimeters(pose.world_T_robot.y));
    values.push_back(Milliradians(pose.world_T_robot.theta));
    values.push_back(Seconds(pose.stamp_s));
  }
  return Dumped({{"op", kind}, {"run", run}, {"from", from}, {"poses", std::move(values)}});
}

MessagePtr CandidatesMessage(int run, const std::vector<loop_closure::ClosureRecord>& candidates,
                             const std::vector<std::size_t>& positions) {
  json changed = json::array();
  for (const std::size_t p : positions) changed.push_back(CandidateJson(p, candidates.at(p)));
  return Dumped({{"op", "candidates"},
                 {"run", run},
                 {"total", candidates.size()},
                 {"changed", std::move(changed)}});
}

}  // namespace gmapping_spa::view
