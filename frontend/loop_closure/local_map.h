// SPDX-License-Identifier: BSD-3-Clause
// The map that a few neighboring scans make, in the frame of one of them.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_LOCAL_MAP_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_LOCAL_MAP_H_

#include <functional>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::loop_closure {

// The scan that was taken at a node of the pose graph.
using ScanOfNode = std::function<sensor::LaserScan(int node)>;

// Nodes first ... last, both included.
struct NodeRange {
  int first = 0;
  int last = 0;
};

// The nodes of a path around `center`, as far as `reach_m` of driving to either side.
NodeRange NodesAround(const std::vector<backend::SE2>& world_T_nodes, int center, double reach_m);

// Enters the scans of the nodes into a grid whose frame is that of node `reference`.
map::OccupancyGrid BuildLocalMap(const std::vector<backend::SE2>& world_T_nodes,
                                 const ScanOfNode& scan_of_node, NodeRange nodes, int reference,
                                 const map::OccupancyGrid::Options& grid);

// End points of the scans of the nodes in the frame of node `reference`, at most one a cell of
// `cell_m`.
scan_matching::ScanPoints JoinScans(const std::vector<backend::SE2>& world_T_nodes,
                                    const ScanOfNode& scan_of_node, NodeRange nodes, int reference,
                                    double cell_m);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_LOCAL_MAP_H_
