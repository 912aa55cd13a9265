// SPDX-License-Identifier: BSD-3-Clause
// A SLAM node without ROS: messages in as bytes, snapshots and map -> odom out.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_SLAM_NODE_CORE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "experiments/ros/node_output.h"
#include "experiments/ros/parameters.h"
#include "experiments/ros/scan_counts.h"

namespace gmapping_spa::ros {

// Whether the robot is known to be somewhere in the map of another run that --map_session names.
enum class OldMap : std::uint8_t { kNone, kSearched, kFound };

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

  // The pose of the robot at the first scan; says why not where the first scan has been used, or
  // the map frame is that of an old map. Else the map frame is the pose of the robot at the first
  // scan.
  virtual void SetStartPose(const std::string& frame, const SpatialPose& map_T_robot) = 0;

  // Nothing before the first scan with odometry, and while the robot is not found in the old map.
  virtual std::optional<PlanarPose> map_T_odom() const = 0;
  virtual OldMap old_map() const = 0;
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
