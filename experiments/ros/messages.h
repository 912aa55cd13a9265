// SPDX-License-Identifier: BSD-3-Clause
// What a node knows, as messages: templates, as the types of ROS 1 and ROS 2 have other names and
// the same members.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_MESSAGES_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_MESSAGES_H_

#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "experiments/ros/node_output.h"
#include "experiments/ros/slam_node_core.h"

namespace gmapping_spa::ros {

template <typename Position>  // a point or a translation
void SetPosition(const PlanarPose& pose, Position* position) {
  position->x = pose.x_m;
  position->y = pose.y_m;
}

template <typename Quaternion>
void SetHeading(const PlanarPose& pose, Quaternion* quaternion) {
  quaternion->z = std::sin(pose.heading_rad / 2.0);
  quaternion->w = std::cos(pose.heading_rad / 2.0);
}

// Of geometry_msgs/Pose.
template <typename Pose>
SpatialPose SpatialPoseOf(const Pose& pose) {
  return {pose.position.x,    pose.position.y,    pose.position.z,   pose.orientation.x,
          pose.orientation.y, pose.orientation.z, pose.orientation.w};
}

// nav_msgs/OccupancyGrid
template <typename Grid, typename Header>
Grid GridOf(const Snapshot& snapshot, const Header& header) {
  Grid grid;
  grid.header = header;
  grid.info.map_load_time = header.stamp;
  grid.info.resolution = static_cast<float>(snapshot.resolution_m);
  grid.info.width = static_cast<std::uint32_t>(snapshot.width);
  grid.info.height = static_cast<std::uint32_t>(snapshot.height);
  SetPosition(snapshot.map_T_cells, &grid.info.origin.position);
  SetHeading(snapshot.map_T_cells, &grid.info.origin.orientation);
  grid.data = snapshot.cells;
  return grid;
}

// visualization_msgs/Marker
template <typename Marker, typename Header>
Marker EmptyMarker(const Header& header, const char* name, std::int32_t type, double width_m,
                   float red, float green) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = width_m;
  marker.color.r = red;
  marker.color.g = green;
  marker.color.b = 1.0F - red;
  marker.color.a = 1.0F;
  return marker;
}

template <typename Marker>
void AddPoint(const PlanarPose& pose, Marker* marker) {
  marker->points.emplace_back();
  SetPosition(pose, &marker->points.back());
}

// visualization_msgs/MarkerArray: the path of the pose graph as a line, its nodes as points, loop
// closures as lines.
template <typename Markers, typename Header>
Markers MarkersOf(const Snapshot& snapshot, const Header& header) {
  using Marker = typename std::decay_t<decltype(Markers::markers)>::value_type;
  Marker path = EmptyMarker<Marker>(header, "path", Marker::LINE_STRIP, 0.03, 0.0F, 0.4F);
  Marker nodes = EmptyMarker<Marker>(header, "nodes", Marker::POINTS, 0.08, 0.0F, 0.2F);
  Marker closures =
      EmptyMarker<Marker>(header, "loop_closures", Marker::LINE_LIST, 0.04, 1.0F, 0.3F);
  for (const PlanarPose& pose : snapshot.map_T_nodes) AddPoint(pose, &path);
  nodes.points = path.points;
  for (const auto& [from, to] : snapshot.closures) {
    AddPoint(from, &closures);
    AddPoint(to, &closures);
  }
  Markers markers;
  for (Marker* marker : {&path, &nodes, &closures}) {
    marker->action = Marker::ADD;
    // A line of less than two points is an error for rviz.
    if (marker->points.size() < 2) marker->action = Marker::DELETE;
    markers.markers.push_back(std::move(*marker));
  }
  return markers;
}

// Adds to a diagnostic_msgs/DiagnosticArray whether map -> odom is known in an old map.
template <typename Diagnostics>
void AddOldMap(OldMap old_map, const std::string& node, Diagnostics* diagnostics) {
  if (old_map == OldMap::kNone) return;
  diagnostics->status.emplace_back();
  auto& status = diagnostics->status.back();
  using Status = std::decay_t<decltype(status)>;
  status.name = node + ": localization";
  const bool is_found = old_map == OldMap::kFound;
  status.level = is_found ? Status::OK : Status::WARN;
  status.message = is_found
                       ? "the robot is found in the map of map_session"
                       : "the robot is not found in the map of map_session: there is no map -> "
                         "odom";
}

// diagnostic_msgs/DiagnosticArray: where the scans went; a warning where there is a problem.
template <typename Diagnostics>
Diagnostics DiagnosticsOf(const ScanCounts& counts, OldMap old_map, const std::string& node) {
  Diagnostics diagnostics;
  diagnostics.status.emplace_back();
  auto& status = diagnostics.status.back();
  using Status = std::decay_t<decltype(status)>;
  status.name = node + ": scans";
  const std::string problem = ProblemOf(counts);
  status.level = problem.empty() ? Status::OK : Status::WARN;
  status.message = problem.empty() ? "all scans are used" : problem;
  for (const auto& [name, value] : NamedCounts(counts)) {
    status.values.emplace_back();
    status.values.back().key = name;
    status.values.back().value = std::to_string(value);
  }
  AddOldMap(old_map, node, &diagnostics);
  return diagnostics;
}

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_MESSAGES_H_
