// SPDX-License-Identifier: BSD-3-Clause
// What a node of ROS 1 or ROS 2 publishes, without types of either. Messages of ROS 1 do not
// compile as C++20: what nodes include keeps to C++17.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_NODE_OUTPUT_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_NODE_OUTPUT_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gmapping_spa::ros {

enum class Severity : std::uint8_t { kInfo, kWarning, kError };

struct PlanarPose {
  double x_m = 0.0, y_m = 0.0, heading_rad = 0.0;
};

// The state of the SLAM at a scan.
struct Snapshot {
  double stamp_s = 0.0;  // of the scan

  // Cells as nav_msgs/OccupancyGrid has them: -1 unknown, 0 free, 100 occupied, row by row.
  std::vector<std::int8_t> cells;
  int width = 0, height = 0;
  double resolution_m = 0.0;
  PlanarPose map_T_cells;  // their lower left corner and their axes

  std::vector<PlanarPose> map_T_nodes;                      // of the pose graph
  std::vector<std::pair<PlanarPose, PlanarPose>> closures;  // poses of the two nodes of each
  double entropy = 0.0;                                     // of the particles' weights
};

// Called from the thread of the SLAM, Say of any thread.
class NodeOutput {
 public:
  virtual ~NodeOutput() = default;
  virtual void Say(Severity severity, const std::string& line) = 0;
  virtual void Show(const Snapshot& snapshot) = 0;
};

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_NODE_OUTPUT_H_
