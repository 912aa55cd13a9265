// SPDX-License-Identifier: BSD-3-Clause
// What the node knows, as messages of ROS 1.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_ROS1_MESSAGES_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_ROS1_MESSAGES_H_

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "experiments/ros/node_output.h"
#include "experiments/ros/slam_node_core.h"

namespace gmapping_spa::ros {

nav_msgs::OccupancyGrid GridOf(const Snapshot& snapshot, const std::string& map_frame);

// The path of the pose graph as a line, its nodes as points, loop closures as lines.
visualization_msgs::MarkerArray MarkersOf(const Snapshot& snapshot, const std::string& map_frame);

geometry_msgs::Transform TransformOf(const PlanarPose& a_T_b);
SpatialPose SpatialPoseOf(const geometry_msgs::Pose& pose);

// Where the scans went; a warning where any was left out.
diagnostic_msgs::DiagnosticArray DiagnosticsOf(const ScanCounts& counts, const std::string& node);

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_ROS1_MESSAGES_H_
