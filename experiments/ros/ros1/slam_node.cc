// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/ros1/slam_node.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/serialization.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <chrono>
#include <exception>
#include <iostream>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/apps/app.h"
#include "experiments/ros/messages.h"

namespace gmapping_spa::ros {
namespace {

// As a bag holds it.
template <typename Message>
std::string BytesOf(const Message& message) {
  std::string bytes(::ros::serialization::serializationLength(message), '\0');
  ::ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                       static_cast<std::uint32_t>(bytes.size()));
  ::ros::serialization::serialize(stream, message);
  return bytes;
}

std::int64_t Now_ns() { return static_cast<std::int64_t>(::ros::Time::now().toNSec()); }

}  // namespace

SlamNode::SlamNode(const NodeOptions& options)
    : options_(options),
      map_(handle_.advertise<nav_msgs::OccupancyGrid>("map", 1, /*latch=*/true)),
      map_metadata_(handle_.advertise<nav_msgs::MapMetaData>("map_metadata", 1, /*latch=*/true)),
      entropy_(private_handle_.advertise<std_msgs::Float64>("entropy", 1, /*latch=*/true)),
      graph_(private_handle_.advertise<visualization_msgs::MarkerArray>("graph", 1,
                                                                        /*latch=*/true)),
      diagnostics_(handle_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1)),
      core_(MakeSlamNodeCore(options, Serialization::kRos1, this)) {
  // Queues without a limit: the callbacks do not wait, and the core counts what it has no room for.
  const ::ros::TransportHints hints = ::ros::TransportHints().tcpNoDelay();
  tf_static_ = handle_.subscribe("/tf_static", 0, &SlamNode::OnTf, this, hints);
  tf_ = handle_.subscribe("/tf", 0, &SlamNode::OnTf, this, hints);
  scans_ = handle_.subscribe("scan", 0, &SlamNode::OnScan, this, hints);
  start_pose_ = handle_.subscribe("initialpose", 1, &SlamNode::OnPose, this);
  set_pose_ = handle_.subscribe("set_pose", 1, &SlamNode::OnPose, this);
  dynamic_map_ = handle_.advertiseService("dynamic_map", &SlamNode::OnDynamicMap, this);
  save_session_ = private_handle_.advertiseService("save_session", &SlamNode::OnSaveSession, this);
  if (options_.transform_publish_period_s > 0.0) {
    transform_thread_ = std::thread([this] { PublishTransforms(); });
  }
}

SlamNode::~SlamNode() {
  ::ros::shutdown();
  if (transform_thread_.joinable()) transform_thread_.join();
}

void SlamNode::Spin() {
  ::ros::AsyncSpinner spinner(2);  // while one saves a session, the other takes scans
  spinner.start();
  auto next_diagnostics = std::chrono::steady_clock::now();
  std::set<std::string> said;  // once each
  while (::ros::ok() && apps::ReceivedSignal() == 0 && !core_->failed()) {
    ::ros::WallDuration(0.05).sleep();
    if (std::chrono::steady_clock::now() < next_diagnostics) continue;
    next_diagnostics += std::chrono::seconds(1);
    const ScanCounts counts = core_->counts();
    const std::string problem = ProblemOf(counts);
    if (!problem.empty() && said.insert(problem).second) {
      Say(Severity::kWarning, problem + " (topic " + scans_.getTopic() + ")");
    }
    auto array = DiagnosticsOf<diagnostic_msgs::DiagnosticArray>(counts, core_->old_map(),
                                                                 ::ros::this_node::getName());
    array.header.stamp = ::ros::Time::now();
    diagnostics_.publish(array);
  }
  spinner.stop();
  core_->Finish();
}

void SlamNode::Say(Severity severity, const std::string& line) {
  if (!::ros::ok()) {  // its console is closed
    std::cerr << ::ros::this_node::getName() << ": " << line << '\n';
    return;
  }
  if (severity == Severity::kInfo) ROS_INFO_STREAM(line);
  if (severity == Severity::kWarning) ROS_WARN_STREAM(line);
  if (severity == Severity::kError) ROS_ERROR_STREAM(line);
}

void SlamNode::Show(const Snapshot& snapshot) {
  std_msgs::Header header;
  header.frame_id = options_.map_frame;
  header.stamp.fromSec(snapshot.stamp_s);
  auto grid = GridOf<nav_msgs::OccupancyGrid>(snapshot, header);
  map_.publish(grid);
  map_metadata_.publish(grid.info);
  graph_.publish(MarkersOf<visualization_msgs::MarkerArray>(snapshot, header));
  std_msgs::Float64 entropy;
  entropy.data = snapshot.entropy;
  entropy_.publish(entropy);
  const std::lock_guard<std::mutex> lock(mutex_);
  latest_map_ = std::move(grid);
}

void SlamNode::OnScan(const sensor_msgs::LaserScan::ConstPtr& scan) {
  // Senders of ROS 1 count their messages; those that do not leave a zero.
  const std::uint32_t number = scan->header.seq;
  if (scan_number_ && number > *scan_number_ + 1) core_->CountLost(number - *scan_number_ - 1);
  scan_number_ = number;
  core_->TakeScan(BytesOf(*scan), Now_ns());
}

void SlamNode::OnTf(const tf2_msgs::TFMessage::ConstPtr& transforms) {
  core_->TakeTf(BytesOf(*transforms), Now_ns());
}

void SlamNode::OnPose(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr& pose) {
  core_->SetStartPose(pose->header.frame_id, SpatialPoseOf(pose->pose.pose));
}

bool SlamNode::OnDynamicMap(nav_msgs::GetMap::Request& /*request*/,
                            nav_msgs::GetMap::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // A failed call says more than a map without cells.
  if (!latest_map_ || latest_map_->data.empty()) return false;
  response.map = *latest_map_;
  return true;
}

bool SlamNode::OnSaveSession(std_srvs::Trigger::Request& /*request*/,
                             std_srvs::Trigger::Response& response) {
  try {
    core_->SaveSession();
    response.success = 1;
    response.message = "saved";
  } catch (const std::exception& error) {
    response.success = 0;
    response.message = error.what();
  }
  return true;
}

void SlamNode::PublishTransforms() {
  ::ros::Rate rate(1.0 / options_.transform_publish_period_s);
  const ::ros::Duration delay(options_.tf_delay_s.value_or(options_.transform_publish_period_s));
  for (; ::ros::ok(); rate.sleep()) {
    const std::optional<PlanarPose> map_T_odom = core_->map_T_odom();
    if (!map_T_odom) continue;
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = options_.map_frame;
    transform.header.stamp = ::ros::Time::now() + delay;
    transform.child_frame_id = core_->odom_frame();
    SetPosition(*map_T_odom, &transform.transform.translation);
    SetHeading(*map_T_odom, &transform.transform.rotation);
    broadcaster_.sendTransform(transform);
  }
}

}  // namespace gmapping_spa::ros
