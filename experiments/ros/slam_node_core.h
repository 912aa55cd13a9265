// SPDX-License-Identifier: BSD-3-Clause
// A SLAM node without ROS: messages in as bytes, snapshots and map -> odom out.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/ros/node_output.h"
#include "experiments/ros/parameters.h"

namespace gmapping_spa::ros {

// Where the scans went. received = throttled + refused + after_time_jump + waiting + used, and
// some that are held until later ones and their odometry have come.
struct ScanCounts {
  std::int64_t lost = 0;  // on the way here, as gaps in their numbers tell
  std::int64_t received = 0;
  std::int64_t throttled = 0;           // left out by throttle_scans
  std::int64_t refused = 0;             // for want of room
  std::int64_t after_time_jump = 0;     // refused, as the clock went back
  std::int64_t waiting = 0;             // for the SLAM
  std::int64_t used = 0;                // by the SLAM
  std::int64_t transforms_refused = 0;  // messages, for want of room
};

// Whether all that came is used, was to be left out, or waits.
bool IsComplete(const ScanCounts& counts);

// By the names above.
std::vector<std::pair<std::string, std::int64_t>> NamedCounts(const ScanCounts& counts);

// A pose in space, as geometry_msgs/Pose has it.
struct SpatialPose {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double qx = 0.0, qy = 0.0, qz = 0.0, qw = 1.0;
};

// Reads messages as bags are read (frontend/rosbag), in a thread of its own. All functions may be
// called from any thread and do not wait for the SLAM, but the destructor, SaveSession and Finish.
class SlamNodeCore {
 public:
  virtual ~SlamNodeCore() = default;

  // A sensor_msgs/LaserScan or tf2_msgs/TFMessage, serialized; the time is that at which it came.
  virtual void TakeScan(std::string_view data, std::int64_t time_ns) = 0;
  virtual void TakeTf(std::string_view data, std::int64_t time_ns) = 0;
  // Scans did not get here.
  virtual void CountLost(std::int64_t scans) = 0;

  // The pose of the robot at the first scan; says why not where the first scan has been used. Until
  // then the map frame is the pose of the robot at the first scan.
  virtual void SetStartPose(const std::string& frame, const SpatialPose& map_T_robot) = 0;

  // Nothing before the first scan with odometry.
  virtual std::optional<PlanarPose> map_T_odom() const = 0;
  virtual const std::string& odom_frame() const = 0;
  virtual ScanCounts counts() const = 0;
  // Whether there is no point in going on: Finish throws.
  virtual bool failed() const = 0;

  // Writes the session to the file that --save_session names, when the scan at hand is used. Throws
  // std::runtime_error with one line where it names none, or that is not possible.
  virtual void SaveSession() = 0;

  // Uses what waits, for ten seconds at most, then makes the results and writes them where
  // --output_dir says. Throws std::runtime_error with one line where the SLAM failed. Call it once.
  virtual void Finish() = 0;
};

enum class Serialization : std::uint8_t { kRos1, kCdr };

// Flags say what is not in `options`. Throws std::runtime_error where they make no sense. `output`
// outlives the node.
std::unique_ptr<SlamNodeCore> MakeSlamNodeCore(const NodeOptions& options,
                                               Serialization serialization, NodeOutput* output);

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_
