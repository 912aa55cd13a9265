// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/scan_insertion.h"

#include <algorithm>
#include <cmath>

namespace gmapping_spa::map {
void InsertScan(const sensor::LaserScan& scan, const backend::SE2& world_T_robot,
                const InsertionOptions& options, OccupancyGrid* grid) {
  const backend::SE2 world_T_laser = world_T_robot * scan.robot_T_laser;
  const double cells_per_m = 1.0 / grid->resolution_m();
  const double x = world_T_laser.x * cells_per_m, y = world_T_laser.y * cells_per_m;
  const CellIndex origin{FloorToCell(x), FloorToCell(y)};
  for (const sensor::Beam& beam : scan.beams) {
    const bool hit = beam.status == sensor::BeamStatus::kHit;
    const bool clears = beam.status == sensor::BeamStatus::kNoReturn && options.no_return_clears;
    if (!hit && !clears) continue;
    const double angle = world_T_laser.theta + beam.angle_rad;
    const double range = beam.range_m * cells_per_m;
    const double end_x = x + range * std::cos(angle), end_y = y + range * std::sin(angle);
    const double margin = hit ? std::min(options.clear_margin_m, beam.range_m) * cells_per_m : 0.0;
    grid->AddPasses(origin, {FloorToCell(end_x - margin * std::cos(angle)),
                             FloorToCell(end_y - margin * std::sin(angle))});
    if (hit) grid->AddHit(end_x, end_y);
  }
}

}  // namespace gmapping_spa::map
