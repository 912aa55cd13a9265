// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/map_history.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Index = TrajectoryTree::Index;

// The part of the tree that all leaves share: from the root up to the first fork.
std::vector<SE2> TrunkOf(const TrajectoryTree& tree) {
  std::vector<int> width;  // vertices of each step
  for (const TrajectoryTree::Vertex& vertex : tree.vertices()) {
    if (vertex.step >= static_cast<int>(width.size())) width.resize(vertex.step + 1, 0);
    ++width[vertex.step];
  }
  const auto trunk_steps = std::find_if(width.begin(), width.end(), [](int n) { return n != 1; });
  std::vector<SE2> trunk(trunk_steps - width.begin());
  for (const TrajectoryTree::Vertex& vertex : tree.vertices()) {
    if (vertex.step < static_cast<int>(trunk.size())) trunk[vertex.step] = vertex.world_T_robot;
  }
  return trunk;
}

}  // namespace

MapHistory::MapHistory(const Options& options, const map::OccupancyGrid::Options& grid,
                       const map::InsertionOptions& insertion)
    : options_(options), empty_(grid), insertion_(insertion) {
  CHECK_GE(options.snapshot_every, 1);
}

bool MapHistory::Moved(const SE2& a, const SE2& b) const {
  const Eigen::Vector3d moved = Minus(a, b);
  return std::hypot(moved.x(), moved.y()) > options_.tolerance_m ||
         std::abs(moved.z()) > options_.tolerance_rad;
}

void MapHistory::DropSnapshotsThatMoved(const std::vector<SE2>& trunk) {
  const std::size_t comparable = std::min(trunk.size(), entered_.size());
  std::size_t same = 0;
  while (same < comparable && !Moved(trunk[same], entered_[same])) ++same;
  while (!snapshots_.empty() && snapshots_.back().steps > static_cast<int>(same)) {
    snapshots_.pop_back();
  }
  entered_.resize(snapshots_.empty() ? 0 : snapshots_.back().steps);
}

void MapHistory::Forget() {
  snapshots_.clear();
  entered_.clear();
}

std::vector<map::OccupancyGrid> MapHistory::Rebuild(const TrajectoryTree& tree,
                                                    const std::vector<Index>& leaves,
                                                    const ScanOfStep& scan_of_step) {
  const std::vector<SE2> trunk = TrunkOf(tree);
  DropSnapshotsThatMoved(trunk);

  map::OccupancyGrid map = snapshots_.empty() ? empty_ : snapshots_.back().map;
  for (int step = static_cast<int>(entered_.size()); step < static_cast<int>(trunk.size());
       ++step) {
    map::InsertScan(scan_of_step(step), trunk[step], insertion_, &map);
    entered_.push_back(trunk[step]);
    if ((step + 1) % options_.snapshot_every == 0) snapshots_.push_back({step + 1, map});
  }
  entered_.resize(snapshots_.empty() ? 0 : snapshots_.back().steps);

  // Beyond the trunk each vertex continues the map of its parent, which all but the last child
  // copy.
  const auto& vertices = tree.vertices();
  std::vector<int> heirs(vertices.size(), 0);  // children, and leaves that end there
  for (const TrajectoryTree::Vertex& vertex : vertices) {
    if (vertex.parent != TrajectoryTree::kNone) ++heirs[vertex.parent];
  }
  for (const Index leaf : leaves) ++heirs[leaf];
  std::vector<std::optional<map::OccupancyGrid>> maps(vertices.size());
  const auto inherit = [&](Index from) {
    return --heirs[from] == 0 ? *std::exchange(maps[from], std::nullopt) : *maps[from];
  };
  for (Index i = 0; i < static_cast<Index>(vertices.size()); ++i) {
    const TrajectoryTree::Vertex& vertex = vertices[i];
    const int trunk_end = static_cast<int>(trunk.size()) - 1;
    if (vertex.step < trunk_end) continue;
    if (vertex.step == trunk_end) {
      maps[i] = std::move(map);  // NOLINT(bugprone-use-after-move): one vertex ends the trunk
      continue;
    }
    maps[i] = inherit(vertex.parent);
    map::InsertScan(scan_of_step(vertex.step), vertex.world_T_robot, insertion_, &*maps[i]);
  }
  std::vector<map::OccupancyGrid> result;
  result.reserve(leaves.size());
  for (const Index leaf : leaves) result.push_back(inherit(leaf));
  return result;
}

}  // namespace gmapping_spa::particle_filter
