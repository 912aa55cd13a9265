// SPDX-License-Identifier: BSD-3-Clause
// A node without ROS that is given what a robot in a room measures.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_ROS_DRIVEN_NODE_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_ROS_DRIVEN_NODE_H_

#include <gflags/gflags.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "backend/se2.h"
#include "experiments/ros/slam_node_core.h"
#include "tests/frontend/rosbag/small_bag.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::ros {

inline constexpr std::int64_t kStart_ns = 1000 * rosbag::kSecond_ns;

// x 5 m, y 6 m, heading 0.5 rad.
inline const SpatialPose kSomewhere{5.0, 6.0, 0.0, 0.0, 0.0, std::sin(0.25), std::cos(0.25)};

class Listener : public NodeOutput {
 public:
  void Say(Severity severity, const std::string& line) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (severity != Severity::kInfo) lines_.push_back(line);
  }
  void Show(const Snapshot& snapshot) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    snapshots_.push_back(snapshot);
  }
  std::vector<std::string> lines() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return lines_;
  }
  std::vector<Snapshot> snapshots() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return snapshots_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
  std::vector<Snapshot> snapshots_;
};

// A robot in a room, ten scans a second, at 0.2 m/s; its odometry begins somewhere.
class DrivenNode : public testing::Test {
 protected:
  DrivenNode() {
    gflags::SetCommandLineOption("base_frame", "base_link");
    gflags::SetCommandLineOption("odom_frame", "odom");
    gflags::SetCommandLineOption("reorder_window_s", "0.5");
    options_.map_update_interval_s = 1.0;
  }

  static std::int64_t Time_ns(int number) { return kStart_ns + number * rosbag::kSecond_ns / 10; }
  static backend::SE2 RoomPose(int number) { return {0.02 * number, 0.0, 0.0}; }

  void Begin() {
    core_ = MakeSlamNodeCore(options_, Serialization::kRos1, &listener_);
    core_->TakeTf(rosbag::TfBytes(rosbag::Encoding::kRos1, kStart_ns, "base_link", "laser",
                                  rosbag::Planar(0.1, 0.0, 0.0)),
                  kStart_ns);
  }

  void Give(int number) {
    const backend::SE2 odom_T_robot = odom_T_start_ * RoomPose(number);
    core_->TakeTf(
        rosbag::TfBytes(rosbag::Encoding::kRos1, Time_ns(number), "odom", "base_link",
                        rosbag::Planar(odom_T_robot.x, odom_T_robot.y, odom_T_robot.theta)),
        Time_ns(number));
    rosbag::ScanFields fields;
    fields.angle_min_rad = static_cast<float>(-std::numbers::pi / 2.0);
    fields.angle_increment_rad = static_cast<float>(std::numbers::pi / 180.0);
    fields.ranges_m.clear();
    const synthetic::Laser laser{.robot_T_laser = {0.1, 0.0, 0.0}};
    for (const sensor::Beam& beam :
         synthetic::Scan(synthetic::Room(), RoomPose(number), laser).beams) {
      fields.ranges_m.push_back(static_cast<float>(beam.range_m));
    }
    core_->TakeScan(rosbag::ScanBytes(rosbag::Encoding::kRos1, Time_ns(number), fields),
                    Time_ns(number));
  }

  void Drive(int scans) {
    Begin();
    for (int i = 0; i < scans; ++i) Give(i);
  }

  backend::SE2 MapTOdom() const {
    const PlanarPose pose = core_->map_T_odom().value();
    return {pose.x_m, pose.y_m, pose.heading_rad};
  }

  // False after two minutes: sanitizers are slow.
  static bool WaitUntil(const std::function<bool()>& is_so) {
    for (int i = 0; i < 12000 && !is_so(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return is_so();
  }

  const gflags::FlagSaver saver_;
  backend::SE2 odom_T_start_{3.0, -1.0, 0.7};
  NodeOptions options_;
  Listener listener_;
  std::unique_ptr<SlamNodeCore> core_;
};

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_ROS_DRIVEN_NODE_H_
