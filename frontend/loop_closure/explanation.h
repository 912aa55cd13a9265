// SPDX-License-Identifier: BSD-3-Clause
// How much of what scans saw a local map explains.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_EXPLANATION_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_EXPLANATION_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/loop_closure/local_map.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::loop_closure {

// Part of the points that end in cells of the map that some beam has met.
double Overlap(const map::OccupancyGrid& map, const scan_matching::ScanPoints& points,
               const backend::SE2& map_T_scan);

// Of the points in the known part of the map those that end near an obstacle.
struct Explanation {
  int known = 0;
  int explained = 0;
  double part() const { return known > 0 ? static_cast<double>(explained) / known : 0.0; }
};

Explanation Explain(const map::OccupancyGrid& map, const scan_matching::ScanPoints& points,
                    const backend::SE2& map_T_scan, double occupied_threshold, int reach_cells);

// The inliers of an alignment per point in the known part of the map.
double InlierRatio(const map::OccupancyGrid& map, const scan_matching::ScanPoints& points,
                   const scan_matching::GaussNewton::Alignment& alignment);

// The ratio at which every second scan of the nodes explains the others, seen from the reference:
// about 1 in a building that stands still, seen well; less among people, or with few beams. 1 if
// there are too few scans to tell.
double UsualInlierRatio(const std::vector<backend::SE2>& world_T_nodes,
                        const ScanOfNode& scan_of_node, NodeRange nodes, int reference,
                        double cell_m, const map::OccupancyGrid::Options& grid,
                        const scan_matching::GaussNewton& gauss_newton);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_EXPLANATION_H_
