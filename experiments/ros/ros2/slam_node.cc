// SPDX-License-Identifier: BSD-3-Clause
// A node for ROS 2 in place of slam_gmapping. Written against the documented interface of ROS 2
// Humble; it has never been compiled (README.md).
#include <tf2_ros/transform_broadcaster.h>
#include <chrono>
#include <cstdint>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <exception>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <nav_msgs/msg/map_meta_data.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/srv/get_map.hpp>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <sstream>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/header.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>
#include <visualization_msgs/msg/marker_array.hpp>

#include "experiments/apps/app.h"
#include "experiments/ros/messages.h"
#include "experiments/ros/node_output.h"
#include "experiments/ros/run_node.h"
#include "experiments/ros/slam_node_core.h"

namespace gmapping_spa::ros {
namespace {

using diagnostic_msgs::msg::DiagnosticArray;
using geometry_msgs::msg::PoseWithCovarianceStamped;
using nav_msgs::msg::OccupancyGrid;
using nav_msgs::srv::GetMap;
using std_srvs::srv::Trigger;
using visualization_msgs::msg::MarkerArray;

class SlamNode : private NodeOutput {
 public:
  SlamNode(const rclcpp::Node::SharedPtr& node, const NodeOptions& options)
      : options_(options), node_(node), broadcaster_(*node) {
    const rclcpp::QoS latched = rclcpp::QoS(1).reliable().transient_local();
    map_ = node_->create_publisher<OccupancyGrid>("map", latched);
    map_metadata_ = node_->create_publisher<nav_msgs::msg::MapMetaData>("map_metadata", latched);
    entropy_ = node_->create_publisher<std_msgs::msg::Float64>("~/entropy", latched);
    graph_ = node_->create_publisher<MarkerArray>("~/graph", latched);
    diagnostics_ = node_->create_publisher<DiagnosticArray>("/diagnostics", 1);
    core_ = MakeSlamNodeCore(options_, Serialization::kCdr, this);
    Subscribe();
    Serve();
  }

  void Spin() {
    rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 3);
    executor.add_node(node_);
    std::thread spinner([&] { executor.spin(); });
    while (rclcpp::ok() && apps::ReceivedSignal() == 0 && !core_->failed()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    executor.cancel();
    spinner.join();
    core_->Finish();
  }

 private:
  void Say(Severity severity, const std::string& line) override {
    if (severity == Severity::kInfo) RCLCPP_INFO_STREAM(node_->get_logger(), line);
    if (severity == Severity::kWarning) RCLCPP_WARN_STREAM(node_->get_logger(), line);
    if (severity == Severity::kError) RCLCPP_ERROR_STREAM(node_->get_logger(), line);
  }

  void Show(const Snapshot& snapshot) override {
    std_msgs::msg::Header header;
    header.frame_id = options_.map_frame;
    header.stamp = rclcpp::Time(static_cast<std::int64_t>(snapshot.stamp_s * 1e9));
    auto grid = GridOf<OccupancyGrid>(snapshot, header);
    map_->publish(grid);
    map_metadata_->publish(grid.info);
    graph_->publish(MarkersOf<MarkerArray>(snapshot, header));
    std_msgs::msg::Float64 entropy;
    entropy.data = snapshot.entropy;
    entropy_->publish(entropy);
    const std::lock_guard<std::mutex> lock(mutex_);
    latest_map_ = std::move(grid);
  }

  void Subscribe() {
    // A group of their own: a session that is being saved does not hold them up.
    rclcpp::SubscriptionOptions in_group;
    in_group.callback_group = messages_ =
        node_->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    const auto tf = [this](const std::shared_ptr<const rclcpp::SerializedMessage>& message) {
      core_->TakeTf(BytesOf(*message), node_->now().nanoseconds());
    };
    const char* const tf_type = "tf2_msgs/msg/TFMessage";
    subscriptions_.push_back(node_->create_generic_subscription(
        "/tf_static", tf_type, rclcpp::QoS(100).reliable().transient_local(), tf, in_group));
    subscriptions_.push_back(
        node_->create_generic_subscription("/tf", tf_type, rclcpp::QoS(1000), tf, in_group));
    rclcpp::SubscriptionOptions counting = in_group;
    counting.event_callbacks.message_lost_callback = [this](rclcpp::QOSMessageLostInfo& lost) {
      core_->CountLost(static_cast<std::int64_t>(lost.total_count_change));
    };
    subscriptions_.push_back(node_->create_generic_subscription(
        "scan", "sensor_msgs/msg/LaserScan", rclcpp::SensorDataQoS().keep_last(1000),
        [this](const std::shared_ptr<const rclcpp::SerializedMessage>& message) {
          core_->TakeScan(BytesOf(*message), node_->now().nanoseconds());
        },
        counting));
    const auto start_pose = [this](const PoseWithCovarianceStamped::ConstSharedPtr& message) {
      core_->SetStartPose(message->header.frame_id, SpatialPoseOf(message->pose.pose));
    };
    for (const char* const topic : {"initialpose", "set_pose"}) {
      subscriptions_.push_back(
          node_->create_subscription<PoseWithCovarianceStamped>(topic, 1, start_pose, in_group));
    }
  }

  void Serve() {
    dynamic_map_ = node_->create_service<GetMap>(
        "dynamic_map", [this](std::shared_ptr<GetMap::Request> /*request*/,
                              std::shared_ptr<GetMap::Response> response) {
          const std::lock_guard<std::mutex> lock(mutex_);
          if (latest_map_) response->map = *latest_map_;
        });
    save_session_ = node_->create_service<Trigger>(
        "~/save_session", [this](std::shared_ptr<Trigger::Request> /*request*/,
                                 std::shared_ptr<Trigger::Response> response) {
          try {
            core_->SaveSession();
            response->success = true;
            response->message = "saved";
          } catch (const std::exception& error) {
            response->message = error.what();
          }
        });
    timers_ = node_->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    diagnostics_timer_ = node_->create_wall_timer(
        std::chrono::seconds(1),
        [this] {
          auto array =
              DiagnosticsOf<DiagnosticArray>(core_->counts(), core_->old_map(), node_->get_name());
          array.header.stamp = node_->now();
          diagnostics_->publish(array);
        },
        timers_);
    if (options_.transform_publish_period_s == 0.0) return;
    transform_timer_ = node_->create_wall_timer(
        std::chrono::duration<double>(options_.transform_publish_period_s),
        [this] { PublishTransform(); }, timers_);
  }

  void PublishTransform() {
    const std::optional<PlanarPose> map_T_odom = core_->map_T_odom();
    if (!map_T_odom) return;
    const double delay_s = options_.tf_delay_s.value_or(options_.transform_publish_period_s);
    geometry_msgs::msg::TransformStamped transform;
    transform.header.frame_id = options_.map_frame;
    transform.header.stamp = node_->now() + rclcpp::Duration::from_seconds(delay_s);
    transform.child_frame_id = core_->odom_frame();
    SetPosition(*map_T_odom, &transform.transform.translation);
    SetHeading(*map_T_odom, &transform.transform.rotation);
    broadcaster_.sendTransform(transform);
  }

  // As a bag holds it: CDR with its header.
  static std::string_view BytesOf(const rclcpp::SerializedMessage& message) {
    const rcl_serialized_message_t& bytes = message.get_rcl_serialized_message();
    return {reinterpret_cast<const char*>(bytes.buffer), bytes.buffer_length};
  }

  const NodeOptions options_;
  const rclcpp::Node::SharedPtr node_;
  tf2_ros::TransformBroadcaster broadcaster_;
  rclcpp::Publisher<OccupancyGrid>::SharedPtr map_;
  rclcpp::Publisher<nav_msgs::msg::MapMetaData>::SharedPtr map_metadata_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr entropy_;
  rclcpp::Publisher<MarkerArray>::SharedPtr graph_;
  rclcpp::Publisher<DiagnosticArray>::SharedPtr diagnostics_;
  std::mutex mutex_;
  std::optional<OccupancyGrid> latest_map_;
  std::unique_ptr<SlamNodeCore> core_;
  // Behind the core, whose functions they call.
  rclcpp::CallbackGroup::SharedPtr messages_, timers_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
  rclcpp::Service<GetMap>::SharedPtr dynamic_map_;
  rclcpp::Service<Trigger>::SharedPtr save_session_;
  rclcpp::TimerBase::SharedPtr diagnostics_timer_, transform_timer_;
};

// But for those that every node has.
std::map<std::string, std::string> ParametersOf(const rclcpp::Node& node) {
  std::map<std::string, std::string> parameters;
  for (const std::string& name : node.list_parameters({}, 0).names) {
    if (name == "use_sim_time" || name == "start_type_description_service") continue;
    if (name.compare(0, 14, "qos_overrides.") == 0) continue;
    const rclcpp::Parameter parameter = node.get_parameter(name);
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      text << parameter.as_double();
    } else {
      text << parameter.value_to_string();
    }
    parameters[name] = text.str();
  }
  return parameters;
}

int RunSlamNode(int argc, char** argv) {
  rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
  std::vector<std::string> words = rclcpp::remove_ros_arguments(argc, argv);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  const int num_words = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  const auto node = std::make_shared<rclcpp::Node>(
      "slam_gmapping", rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(true));
  const int status = RunNode(num_words, pointers.data(), ParametersOf(*node),
                             [&](const NodeParameters& parameters) {
                               for (const std::string& line : parameters.refusals) {
                                 RCLCPP_WARN_STREAM(node->get_logger(), line);
                               }
                               SlamNode(node, parameters.node).Spin();
                             });
  rclcpp::shutdown();
  return status;
}

}  // namespace
}  // namespace gmapping_spa::ros

int main(int argc, char** argv) {
  try {
    return gmapping_spa::ros::RunSlamNode(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": error: " << error.what() << '\n';
    return 1;
  }
}
