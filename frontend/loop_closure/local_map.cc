// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/local_map.h"

#include "frontend/map/scan_insertion.h"
#include "frontend/scan_matching/joined_points.h"

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
  scan_matching::JoinedPoints joined(cell_m);
  for (int node = nodes.first; node <= nodes.last; ++node) {
    joined.Add(scan_matching::MakeEndPoints(scan_of_node(node)),
               Between(world_T_nodes[reference], world_T_nodes[node]));
  }
  return joined.points();
}

}  // namespace gmapping_spa::loop_closure
