// SPDX-License-Identifier: BSD-3-Clause
// The topics, services and timers of the node for ROS 1.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_ROS1_SLAM_NODE_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_ROS1_SLAM_NODE_H_

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/GetMap.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "experiments/ros/node_output.h"
#include "experiments/ros/parameters.h"
#include "experiments/ros/slam_node_core.h"

namespace gmapping_spa::ros {

class SlamNode : private NodeOutput {
 public:
  explicit SlamNode(const NodeOptions& options);
  ~SlamNode() override;

  // Until ROS shuts down, the process receives a signal, or the SLAM fails: throws
  // std::runtime_error then.
  void Spin();

 private:
  void Say(Severity severity, const std::string& line) override;
  void Show(const Snapshot& snapshot) override;

  void OnScan(const sensor_msgs::LaserScan::ConstPtr& scan);
  void OnTf(const tf2_msgs::TFMessage::ConstPtr& transforms);
  void OnPose(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr& pose);
  bool OnDynamicMap(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);
  bool OnSaveSession(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void PublishTransforms();

  const NodeOptions options_;
  ::ros::NodeHandle handle_, private_handle_{"~"};
  ::ros::Publisher map_, map_metadata_, entropy_, graph_, diagnostics_;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::optional<std::uint32_t> scan_number_;  // of the latest scan, by its sender

  std::mutex mutex_;
  std::optional<nav_msgs::OccupancyGrid> latest_map_;

  const std::unique_ptr<SlamNodeCore> core_;
  // Behind the core, whose functions they call.
  ::ros::Subscriber scans_, tf_, tf_static_, start_pose_, set_pose_;
  ::ros::ServiceServer dynamic_map_, save_session_;
  std::thread transform_thread_;
};

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_ROS1_SLAM_NODE_H_
