// SPDX-License-Identifier: BSD-3-Clause
// The SLAM of a node: when it has something to show, and what.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_NODE_SLAM_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_NODE_SLAM_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "backend/se2.h"
#include "experiments/apps/json.h"
#include "experiments/apps/session_saver.h"
#include "experiments/apps/slam_run.h"
#include "experiments/ros/node_output.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::ros {

inline PlanarPose Planar(const backend::SE2& pose) { return {pose.x, pose.y, pose.theta}; }

// -sum w log w of the normalized weights exp(gain * log_weight).
double EntropyOfWeights(const std::vector<double>& log_weights, double gain);

class NodeSlam {
 public:
  // Reads flags; throws std::runtime_error where they make no sense. `minimum_score`: see
  // NodeOptions.
  NodeSlam(double map_update_interval_s, std::optional<double> minimum_score);

  // Whether it goes on in the map of another run, --map_session.
  bool has_old_map() const { return run_->gmapping().session().has_value(); }

  // Returns the robot's pose at the scan; in an old map nothing while it is not found there.
  std::optional<backend::SE2> AddScan(const sensor::LaserScan& scan);

  // What is known, where map_update_interval_s has passed since the last time and the map has
  // changed: of the first scan at once. An old map is there before the first scan; it is that one
  // while the robot is not found in it, and with --localize always.
  std::optional<Snapshot> DueSnapshot(const backend::SE2& map_T_world);

  // Writes the session to the file that --save_session names. Throws std::runtime_error with one
  // line where it names none, or that is not possible.
  void SaveSession();

  // Says what was noticed, and writes the results where --output_dir says.
  void Finish(const sensor::LogCounts& counts, const std::function<apps::Json()>& input);

 private:
  void MakeRun();

  std::unique_ptr<apps::SlamRun> run_;
  std::unique_ptr<apps::SessionSaver> saver_;  // null without --save_session
  double map_update_interval_s_;
  std::optional<double> minimum_score_;
  double stamp_s_ = 0.0;             // of the latest scan
  std::optional<double> shown_s_;    // of the last snapshot
  std::int64_t shown_changes_ = -1;  // updates and corrections by then
};

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_NODE_SLAM_H_
