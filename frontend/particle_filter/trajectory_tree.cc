#include "frontend/particle_filter/trajectory_tree.h"

#include <glog/logging.h>

#include <algorithm>

namespace gmapping_spa::particle_filter {

TrajectoryTree::Index TrajectoryTree::Append(Index parent, const backend::SE2& world_T_robot) {
  CHECK(parent >= kNone && parent < static_cast<Index>(vertices_.size()));
  vertices_.push_back({world_T_robot, parent});
  return static_cast<Index>(vertices_.size()) - 1;
}

std::vector<backend::SE2> TrajectoryTree::Path(Index leaf) const {
  std::vector<backend::SE2> path;
  for (Index at = leaf; at != kNone; at = vertices_[at].parent) {
    path.push_back(vertices_[at].world_T_robot);
  }
  std::reverse(path.begin(), path.end());
  return path;
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

}  // namespace gmapping_spa::particle_filter
