// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/foxglove_scene.h"

#include <cstddef>
#include <utility>

#include "experiments/view/foxglove_values.h"

namespace gmapping_spa::view {
namespace {

using nlohmann::json;

constexpr int kLineStrip = 0, kLineList = 2;  // of foxglove.LinePrimitive

json Entity(const char* id, const json& time, int type, json points, const json& color) {
  json line = {{"type", type},
               {"pose", FoxglovePose({})},
               {"thickness", 2.0},
               {"scale_invariant", true},
               {"points", std::move(points)},
               {"color", color},
               {"colors", json::array()},
               {"indices", json::array()}};
  json entity = {{"timestamp", time},
                 {"frame_id", "map"},
                 {"id", id},
                 {"lifetime", {{"sec", 0}, {"nsec", 0}}},
                 {"frame_locked", false},
                 {"lines", {std::move(line)}}};
  for (const char* empty :
       {"metadata", "arrows", "cubes", "spheres", "cylinders", "triangles", "texts", "models"}) {
    entity[empty] = json::array();
  }
  return entity;
}

json PointOf(const backend::StampedPose& node) {
  return FoxglovePoint(node.world_T_robot.x, node.world_T_robot.y);
}

}  // namespace

json FoxgloveScene(const RunState& run) {
  const GraphSnapshot& graph = run.graph();
  json path = json::array(), accepted = json::array(), refused = json::array();
  for (const backend::StampedPose& node : graph.nodes) path.push_back(PointOf(node));
  for (const loop_closure::ClosureRecord& candidate : graph.candidates) {
    const bool is_accepted = candidate.verdict == loop_closure::Verdict::kAccepted;
    for (const int node : {candidate.old_node, candidate.node}) {
      (is_accepted ? accepted : refused)
          .push_back(PointOf(graph.nodes.at(static_cast<std::size_t>(node))));
    }
  }
  const json time = FoxgloveTime(run.latest().figures.stamp_s);
  const json blue = {{"r", 0.2}, {"g", 0.5}, {"b", 1.0}, {"a", 1.0}};
  const json green = {{"r", 0.1}, {"g", 0.8}, {"b", 0.3}, {"a", 1.0}};
  const json red = {{"r", 0.9}, {"g", 0.2}, {"b", 0.1}, {"a", 0.4}};
  return {{"deletions", json::array()},
          {"entities",
           {Entity("path", time, kLineStrip, std::move(path), blue),
            Entity("accepted closures", time, kLineList, std::move(accepted), green),
            Entity("refused closures", time, kLineList, std::move(refused), red)}}};
}

}  // namespace gmapping_spa::view
