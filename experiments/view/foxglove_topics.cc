// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/foxglove_topics.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "experiments/view/foxglove_map.h"
#include "experiments/view/foxglove_scene.h"
#include "experiments/view/foxglove_schemas.h"
#include "experiments/view/foxglove_values.h"

namespace gmapping_spa::view {
namespace {

using nlohmann::json;

constexpr int kWarning = 3;  // level of a foxglove.Log

// With {"timestamp", "frame_id"}.
json Stamped(const RunState& run, const char* frame) {
  return {{"timestamp", FoxgloveTime(run.latest().figures.stamp_s)}, {"frame_id", frame}};
}

json PoseMessage(const RunState& run) {
  json message = Stamped(run, "map");
  message["pose"] = FoxglovePose(run.latest().figures.world_T_robot);
  return message;
}

json ParticlesMessage(const RunState& run) {
  json message = Stamped(run, "map");
  json& poses = message["poses"] = json::array();
  for (const ParticleSnapshot& particle : run.latest().particles) {
    poses.push_back(FoxglovePose(particle.world_T_robot));
  }
  return message;
}

json PathMessage(const RunState& run) {
  json message = Stamped(run, "map");
  json& poses = message["poses"] = json::array();
  for (const backend::StampedPose& node : run.graph().nodes) {
    poses.push_back(FoxglovePose(node.world_T_robot));
  }
  return message;
}

// Beams are told as evenly apart from the first to the last one, which they are nearly always.
json ScanMessage(const RunState& run) {
  const sensor::LaserScan& scan = run.latest().scan;
  json message = Stamped(run, "laser");
  message["pose"] = FoxglovePose({});
  message["start_angle"] = scan.beams.empty() ? 0.0 : scan.beams.front().angle_rad;
  message["end_angle"] = scan.beams.empty() ? 0.0 : scan.beams.back().angle_rad;
  json& ranges = message["ranges"] = json::array();
  for (const sensor::Beam& beam : scan.beams) {
    const bool hit = beam.status == sensor::BeamStatus::kHit;
    ranges.push_back(hit ? json(beam.range_m) : json());  // null: not a number
  }
  message["intensities"] = json::array();
  return message;
}

json TransformsMessage(const RunState& run) {
  const json time = FoxgloveTime(run.latest().figures.stamp_s);
  const auto transform = [&](const char* parent, const char* child, const backend::SE2& pose) {
    const json value = FoxglovePose(pose);
    return json{{"timestamp", time},
                {"parent_frame_id", parent},
                {"child_frame_id", child},
                {"translation", value["position"]},
                {"rotation", value["orientation"]}};
  };
  return {{"transforms",
           {transform("map", "base_link", run.latest().figures.world_T_robot),
            transform("base_link", "laser", run.latest().scan.robot_T_laser)}}};
}

json HealthLog(const RunState& run) {
  std::string text;
  for (const auto& [kind, finding] : run.latest().health.findings) {
    text += kind + ": " + finding.message + " (" + std::to_string(finding.count) + ")\n";
  }
  return {{"timestamp", FoxgloveTime(run.latest().figures.stamp_s)},
          {"level", kWarning},
          {"message", text},
          {"name", "health"},
          {"file", ""},
          {"line", 0}};
}

}  // namespace

const std::vector<FoxgloveTopic>& FoxgloveTopics() {
  using Revisions = RunState::Revisions;
  static const std::vector<FoxgloveTopic> kTopics = {
      {"/tf", "foxglove.FrameTransforms", kTransformsSchema, &Revisions::frame, 0.0,
       TransformsMessage},
      {"/pose", "foxglove.PoseInFrame", kPoseSchema, &Revisions::frame, 0.0, PoseMessage},
      {"/particles", "foxglove.PosesInFrame", kPosesSchema, &Revisions::frame, 0.0,
       ParticlesMessage},
      {"/scan", "foxglove.LaserScan", kScanSchema, &Revisions::frame, 0.0, ScanMessage},
      {"/map", "foxglove.Grid", kGridSchema, &Revisions::map, 1.0, FoxgloveMap},
      {"/path", "foxglove.PosesInFrame", kPosesSchema, &Revisions::graph, 0.5, PathMessage},
      {"/graph", "foxglove.SceneUpdate", kSceneSchema, &Revisions::graph, 0.5, FoxgloveScene},
      {"/health", "foxglove.Log", kLogSchema, &Revisions::health, 0.0, HealthLog}};
  return kTopics;
}

}  // namespace gmapping_spa::view
