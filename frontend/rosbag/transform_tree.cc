// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/transform_tree.h"

#include <algorithm>
#include <stdexcept>

#include "backend/text.h"

namespace gmapping_spa::rosbag {
namespace {

// Far above what robots have: a search for each scan takes as long as there are levels.
constexpr std::size_t kMostLevels = 100;

}  // namespace

void TransformTree::Set(const std::string& parent, const std::string& child,
                        const Eigen::Isometry3d& parent_T_child) {
  constexpr std::size_t kMostFrames = 10000;
  if (links_.size() >= kMostFrames && !links_.contains(child)) {
    throw std::runtime_error("expected transforms of at most 10000 frames, found more");
  }
  links_[child] = {parent, parent_T_child};
}

std::vector<TransformTree::Ancestor> TransformTree::AncestorsOf(const std::string& frame) const {
  std::vector<Ancestor> ancestors = {{frame, Eigen::Isometry3d::Identity()}};
  while (true) {
    const Ancestor& last = ancestors.back();
    const auto link = links_.find(last.frame);
    if (link == links_.end()) return ancestors;
    if (ancestors.size() > links_.size()) {
      throw std::runtime_error("expected a tree of transforms, found a loop at the frame " +
                               backend::Quoted(frame));
    }
    if (ancestors.size() > kMostLevels) {
      throw std::runtime_error("expected a tree of transforms of at most " +
                               std::to_string(kMostLevels) +
                               " levels, found more above the frame " + backend::Quoted(frame));
    }
    ancestors.push_back({link->second.parent, link->second.parent_T_child * last.ancestor_T_frame});
  }
}

std::optional<Eigen::Isometry3d> TransformTree::Lookup(const std::string& target,
                                                       const std::string& source) const {
  const std::vector<Ancestor> of_target = AncestorsOf(target);
  for (const Ancestor& a : AncestorsOf(source)) {
    const auto common = std::find_if(of_target.begin(), of_target.end(),
                                     [&](const Ancestor& b) { return a.frame == b.frame; });
    if (common != of_target.end()) return common->ancestor_T_frame.inverse() * a.ancestor_T_frame;
  }
  return std::nullopt;
}

}  // namespace gmapping_spa::rosbag
