// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/explanation.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "frontend/map/scan_insertion.h"
#include "frontend/scan_matching/joined_points.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

double Overlap(const map::OccupancyGrid& map, const scan_matching::ScanPoints& points,
               const SE2& map_T_scan) {
  if (points.empty()) return 0.0;
  const double cells_per_m = 1.0 / map.resolution_m();
  const auto known = std::count_if(points.begin(), points.end(), [&](const auto& point) {
    const Eigen::Vector2d at = map_T_scan * Eigen::Vector2d(point.x_m, point.y_m) * cells_per_m;
    return map.cell({map::FloorToCell(at.x()), map::FloorToCell(at.y())}).visits > 0;
  });
  return static_cast<double>(known) / static_cast<double>(points.size());
}

Explanation Explain(const map::OccupancyGrid& map, const scan_matching::ScanPoints& points,
                    const SE2& map_T_scan, double occupied_threshold, int reach_cells) {
  const double cells_per_m = 1.0 / map.resolution_m();
  Explanation explanation;
  for (const scan_matching::ScanPoint& point : points) {
    const Eigen::Vector2d at = map_T_scan * Eigen::Vector2d(point.x_m, point.y_m) * cells_per_m;
    const map::CellIndex cell{map::FloorToCell(at.x()), map::FloorToCell(at.y())};
    if (map.cell(cell).visits == 0) continue;
    ++explanation.known;
    bool found = false;
    for (int y = -reach_cells; y <= reach_cells && !found; ++y) {
      for (int x = -reach_cells; x <= reach_cells && !found; ++x) {
        const map::Cell& near = map.cell({cell.x + x, cell.y + y});
        found = near.hits > occupied_threshold * near.visits;
      }
    }
    explanation.explained += found ? 1 : 0;
  }
  return explanation;
}

double InlierRatio(const map::OccupancyGrid& map, const scan_matching::ScanPoints& points,
                   const scan_matching::GaussNewton::Alignment& alignment) {
  const double known =
      Overlap(map, points, alignment.world_T_robot) * static_cast<double>(points.size());
  return known > 0.0 ? alignment.inliers / known : 0.0;
}

double UsualInlierRatio(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                        NodeRange nodes, int reference, double cell_m,
                        const map::OccupancyGrid::Options& grid,
                        const scan_matching::GaussNewton& gauss_newton) {
  map::OccupancyGrid map(grid);
  scan_matching::JoinedPoints joined(cell_m);
  for (int node = nodes.first; node <= nodes.last; ++node) {
    const SE2 reference_T_node = Between(world_T_nodes[reference], world_T_nodes[node]);
    if ((node - nodes.first) % 2 == 0) {
      map::InsertScan(scan_of_node(node), reference_T_node, {}, &map);
    } else {
      joined.Add(scan_matching::MakeEndPoints(scan_of_node(node)), reference_T_node);
    }
  }
  const scan_matching::ScanPoints& points = joined.points();
  if (points.empty()) return 1.0;
  return InlierRatio(
      map, points, gauss_newton.Align(map, points, SE2{}, scan_matching::GaussNewton::WeakPrior()));
}

}  // namespace gmapping_spa::loop_closure
