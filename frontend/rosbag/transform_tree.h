// SPDX-License-Identifier: BSD-3-Clause
// The tree of frames that /tf and /tf_static tell.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_TRANSFORM_TREE_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_TRANSFORM_TREE_H_

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gmapping_spa::rosbag {

// Knows the latest transform of each frame.
class TransformTree {
 public:
  // Throws std::runtime_error with one line at the 10001st frame: names that count up are a fault.
  void Set(const std::string& parent, const std::string& child,
           const Eigen::Isometry3d& parent_T_child);

  // target_T_source, or nothing where the two are not connected. Throws std::runtime_error with one
  // line where frames are each other's parents, or have more than 100 of them above each other.
  std::optional<Eigen::Isometry3d> Lookup(const std::string& target,
                                          const std::string& source) const;

 private:
  struct Link {
    std::string parent;
    Eigen::Isometry3d parent_T_child;
  };
  // From the frame to the root.
  struct Ancestor {
    std::string frame;
    Eigen::Isometry3d ancestor_T_frame;
  };
  std::vector<Ancestor> AncestorsOf(const std::string& frame) const;

  std::map<std::string, Link> links_;  // by child
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_TRANSFORM_TREE_H_
