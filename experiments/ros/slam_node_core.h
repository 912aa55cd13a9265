// SPDX-License-Identifier: BSD-3-Clause
// A SLAM node without ROS: messages in as bytes, snapshots and map -> odom out.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "backend/se2.h"
#include "experiments/ros/live_source.h"
#include "experiments/ros/node_output.h"
#include "experiments/ros/node_slam.h"
#include "experiments/ros/parameters.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::ros {

// Where the scans went. received = throttled + refused + after_time_jump + waiting + used, and
// some that are held until later ones and their odometry have come.
struct ScanCounts {
  std::int64_t lost = 0;             // on the way here, as gaps in their numbers tell
  std::int64_t received = 0;
  std::int64_t throttled = 0;        // left out by throttle_scans
  std::int64_t refused = 0;          // for want of room
  std::int64_t after_time_jump = 0;  // refused, as the clock went back
  std::int64_t waiting = 0;          // for the SLAM
  std::int64_t used = 0;             // by the SLAM
  std::int64_t transforms_refused = 0;  // messages, for want of room
};

// By the names above.
std::vector<std::pair<std::string, std::int64_t>> NamedCounts(const ScanCounts& counts);

// Reads messages as bags are read (frontend/rosbag), in a thread of its own. All functions may be
// called from any thread and do not wait for the SLAM, but the destructor and Finish.
class SlamNodeCore {
 public:
  // Flags say what is not in `options`. Throws std::runtime_error where they make no sense.
  SlamNodeCore(const NodeOptions& options, rosbag::Encoding encoding, NodeOutput* output);
  ~SlamNodeCore();

  // A sensor_msgs/LaserScan or tf2_msgs/TFMessage, serialized; the time is that at which it came.
  void TakeScan(std::string_view data, std::int64_t time_ns);
  void TakeTf(std::string_view data, std::int64_t time_ns);
  // Scans did not get here.
  void CountLost(std::int64_t scans);

  // The pose of the robot at the first scan; says why not where the first scan has been used. Until
  // then the map frame is the pose of the robot at the first scan.
  void SetStartPose(const std::string& frame, const backend::SE2& map_T_robot);

  // Nothing before the first scan with odometry.
  std::optional<backend::SE2> map_T_odom() const;
  const std::string& odom_frame() const { return odom_frame_; }
  ScanCounts counts() const;
  // Whether there is no point in going on: Finish throws.
  bool failed() const;

  // Uses what waits, for ten seconds at most, then makes the results and writes them where
  // --output_dir says. Throws std::runtime_error with one line where the SLAM failed.
  void Finish();

 private:
  bool Accepts(std::int64_t time_ns);
  void Work();
  void Use(const sensor::LaserScan& scan);
  void SayFindings();
  void Stop();

  const NodeOptions options_;
  const std::string odom_frame_;
  NodeOutput* const output_;
  LiveSource source_;
  std::unique_ptr<sensor::LogReader> reader_;  // of the thread, as is slam_
  NodeSlam slam_;
  std::map<std::string, std::int64_t> said_;  // findings

  mutable std::mutex mutex_;  // of what follows
  ScanCounts counts_;
  std::int64_t newest_ns_ = 0;
  bool time_jumped_ = false;
  std::string error_;
  backend::SE2 map_T_world_;
  std::optional<backend::SE2> map_T_odom_;

  std::thread thread_;  // last, as it uses all others
};

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_
