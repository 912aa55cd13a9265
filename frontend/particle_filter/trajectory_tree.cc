// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/trajectory_tree.h"

#include <algorithm>
#include <iterator>

namespace gmapping_spa::particle_filter {

TrajectoryTree::Index TrajectoryTree::AddRoot(const backend::SE2& world_T_robot) {
  vertices_.push_back({world_T_robot, {}, kNone, 0});
  return static_cast<Index>(vertices_.size()) - 1;
}

TrajectoryTree::Index TrajectoryTree::Append(Index parent, const backend::SE2& world_T_robot,
                                             const Motion& motion) {
  vertices_.push_back({world_T_robot, motion, parent, vertices_.at(parent).step + 1});
  return static_cast<Index>(vertices_.size()) - 1;
}

std::vector<TrajectoryTree::Vertex> TrajectoryTree::Path(Index leaf) const {
  std::vector<Vertex> path;
  for (Index at = leaf; at != kNone; at = vertices_[at].parent) path.push_back(vertices_[at]);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<backend::SE2> TrajectoryTree::PosesOfPath(Index leaf) const {
  std::vector<backend::SE2> poses(vertices_.at(leaf).step + 1);
  for (Index at = leaf; at != kNone; at = vertices_[at].parent) {
    poses[vertices_[at].step] = vertices_[at].world_T_robot;
  }
  return poses;
}

std::vector<backend::SE2> TrajectoryTree::LatestPoses(Index leaf, int count) const {
  std::vector<backend::SE2> poses;
  for (Index at = leaf; at != kNone && std::ssize(poses) < count; at = vertices_[at].parent) {
    poses.push_back(vertices_[at].world_T_robot);
  }
  return poses;
}

void TrajectoryTree::Prune(std::vector<Index>* leaves) {
  std::vector<bool> kept(vertices_.size(), false);
  for (const Index leaf : *leaves) {
    for (Index at = leaf; at != kNone && !kept[at]; at = vertices_[at].parent) kept[at] = true;
  }
  std::vector<Index> renumbered(vertices_.size(), kNone);
  Index next = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (!kept[i]) continue;
    Vertex vertex = vertices_[i];
    if (vertex.parent != kNone) vertex.parent = renumbered[vertex.parent];
    renumbered[i] = next;
    vertices_[next++] = vertex;
  }
  vertices_.resize(next);
  for (Index& leaf : *leaves) leaf = renumbered[leaf];
}

void TrajectoryTree::Correct(const PathCorrection& correction) {
  for (Vertex& vertex : vertices_) {
    vertex.world_T_robot = correction.Apply(vertex.step, vertex.world_T_robot);
  }
}

}  // namespace gmapping_spa::particle_filter
