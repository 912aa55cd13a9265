// SPDX-License-Identifier: BSD-3-Clause
// What a node of ROS 1 or ROS 2 publishes, without types of either.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_NODE_OUTPUT_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_NODE_OUTPUT_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::ros {

enum class Severity : std::uint8_t { kInfo, kWarning, kError };

// The state of the SLAM at a scan.
struct Snapshot {
  double stamp_s = 0.0;  // of the scan
  map::TrinaryMap map;   // in the world frame
  backend::SE2 map_T_world;
  std::vector<backend::SE2> map_T_nodes;  // of the pose graph
  std::vector<std::pair<backend::SE2, backend::SE2>> closures;  // poses of the two nodes of each
  double entropy = 0.0;  // of the particles' weights, -sum w log w
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
