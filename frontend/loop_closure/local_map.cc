// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/local_map.h"

#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "frontend/map/scan_insertion.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

NodeRange NodesAround(const std::vector<SE2>& world_T_nodes, int center, double reach_m) {
  const auto driven = [&](int from, int to) {
    return (world_T_nodes[to].translation() - world_T_nodes[from].translation()).norm();
  };
  const int count = static_cast<int>(world_T_nodes.size());
  NodeRange range{center, center};
  for (double way = 0.0; range.first > 0; --range.first) {
    if ((way += driven(range.first - 1, range.first)) > reach_m) break;
  }
  for (double way = 0.0; range.last + 1 < count; ++range.last) {
    if ((way += driven(range.last, range.last + 1)) > reach_m) break;
  }
  return range;
}

map::OccupancyGrid BuildLocalMap(const std::vector<SE2>& world_T_nodes,
                                 const ScanOfNode& scan_of_node, NodeRange nodes, int reference,
                                 const map::OccupancyGrid::Options& grid) {
  map::OccupancyGrid map(grid);
  for (int node = nodes.first; node <= nodes.last; ++node) {
    map::InsertScan(scan_of_node(node), Between(world_T_nodes[reference], world_T_nodes[node]), {},
                    &map);
  }
  return map;
}

scan_matching::ScanPoints JoinScans(const std::vector<SE2>& world_T_nodes,
                                    const ScanOfNode& scan_of_node, NodeRange nodes, int reference,
                                    double cell_m) {
  scan_matching::ScanPoints joined;
  std::unordered_set<std::int64_t> taken;
  for (int node = nodes.first; node <= nodes.last; ++node) {
    const SE2 reference_T_node = Between(world_T_nodes[reference], world_T_nodes[node]);
    const SE2 rotation{0, 0, reference_T_node.theta};
    for (const scan_matching::ScanPoint& point : scan_matching::MakeEndPoints(scan_of_node(node))) {
      const Eigen::Vector2d at = reference_T_node * Eigen::Vector2d(point.x_m, point.y_m);
      const auto column = static_cast<std::int64_t>(std::floor(at.x() / cell_m));
      const auto row = static_cast<std::int64_t>(std::floor(at.y() / cell_m));
      if (!taken.insert(column * (std::int64_t{1} << 32) + row).second) continue;
      const Eigen::Vector2d back = rotation * Eigen::Vector2d(point.back_x, point.back_y);
      joined.push_back({at.x(), at.y(), back.x(), back.y()});
    }
  }
  return joined;
}

std::vector<Eigen::Vector2d> PositionsOf(const scan_matching::ScanPoints& points) {
  std::vector<Eigen::Vector2d> positions;
  positions.reserve(points.size());
  for (const scan_matching::ScanPoint& point : points) positions.emplace_back(point.x_m, point.y_m);
  return positions;
}

}  // namespace gmapping_spa::loop_closure
