// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/ros1/messages.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace gmapping_spa::ros {
namespace {

using visualization_msgs::Marker;

geometry_msgs::Quaternion QuaternionOf(double heading_rad) {
  geometry_msgs::Quaternion quaternion;
  quaternion.z = std::sin(heading_rad / 2.0);
  quaternion.w = std::cos(heading_rad / 2.0);
  return quaternion;
}

geometry_msgs::Point PointOf(const PlanarPose& pose) {
  geometry_msgs::Point point;
  point.x = pose.x_m;
  point.y = pose.y_m;
  return point;
}

Marker EmptyMarker(const Snapshot& snapshot, const std::string& map_frame, const char* name,
                   std::int32_t type, double width_m, double red, double green) {
  Marker marker;
  marker.header.frame_id = map_frame;
  marker.header.stamp.fromSec(snapshot.stamp_s);
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = width_m;
  marker.color.r = static_cast<float>(red);
  marker.color.g = static_cast<float>(green);
  marker.color.b = 1.0F - marker.color.r;
  marker.color.a = 1.0F;
  return marker;
}

}  // namespace

nav_msgs::OccupancyGrid GridOf(const Snapshot& snapshot, const std::string& map_frame) {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = map_frame;
  grid.header.stamp.fromSec(snapshot.stamp_s);
  grid.info.map_load_time = grid.header.stamp;
  grid.info.resolution = static_cast<float>(snapshot.resolution_m);
  grid.info.width = static_cast<std::uint32_t>(snapshot.width);
  grid.info.height = static_cast<std::uint32_t>(snapshot.height);
  grid.info.origin.position = PointOf(snapshot.map_T_cells);
  grid.info.origin.orientation = QuaternionOf(snapshot.map_T_cells.heading_rad);
  grid.data = snapshot.cells;
  return grid;
}

visualization_msgs::MarkerArray MarkersOf(const Snapshot& snapshot, const std::string& map_frame) {
  Marker path = EmptyMarker(snapshot, map_frame, "path", Marker::LINE_STRIP, 0.03, 0.0, 0.4);
  Marker nodes = EmptyMarker(snapshot, map_frame, "nodes", Marker::POINTS, 0.08, 0.0, 0.2);
  for (const PlanarPose& pose : snapshot.map_T_nodes) path.points.push_back(PointOf(pose));
  nodes.points = path.points;
  Marker closures =
      EmptyMarker(snapshot, map_frame, "loop_closures", Marker::LINE_LIST, 0.04, 1.0, 0.3);
  for (const auto& [from, to] : snapshot.closures) {
    closures.points.push_back(PointOf(from));
    closures.points.push_back(PointOf(to));
  }
  visualization_msgs::MarkerArray markers;
  for (Marker* marker : {&path, &nodes, &closures}) {
    // A line of less than two points is an error for rviz.
    if (marker->points.size() < 2) marker->action = Marker::DELETE;
    markers.markers.push_back(std::move(*marker));
  }
  return markers;
}

geometry_msgs::Transform TransformOf(const PlanarPose& a_T_b) {
  geometry_msgs::Transform transform;
  transform.translation.x = a_T_b.x_m;
  transform.translation.y = a_T_b.y_m;
  transform.rotation = QuaternionOf(a_T_b.heading_rad);
  return transform;
}

SpatialPose SpatialPoseOf(const geometry_msgs::Pose& pose) {
  return {pose.position.x,    pose.position.y,    pose.position.z,   pose.orientation.x,
          pose.orientation.y, pose.orientation.z, pose.orientation.w};
}

diagnostic_msgs::DiagnosticArray DiagnosticsOf(const ScanCounts& counts, const std::string& node) {
  diagnostic_msgs::DiagnosticStatus status;
  status.name = node + ": scans";
  const bool complete =
      counts.lost + counts.refused + counts.after_time_jump + counts.transforms_refused == 0;
  status.level =
      complete ? diagnostic_msgs::DiagnosticStatus::OK : diagnostic_msgs::DiagnosticStatus::WARN;
  status.message = complete ? "all scans are used" : "scans were left out";
  for (const auto& [name, value] : NamedCounts(counts)) {
    diagnostic_msgs::KeyValue pair;
    pair.key = name;
    pair.value = std::to_string(value);
    status.values.push_back(pair);
  }
  diagnostic_msgs::DiagnosticArray array;
  array.status.push_back(status);
  return array;
}

}  // namespace gmapping_spa::ros
