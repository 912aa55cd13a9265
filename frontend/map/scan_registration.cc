#include "frontend/map/scan_registration.h"

#include <cmath>
#include <cstdlib>

namespace gmapping_spa::map {
namespace {

// Counts a pass for every cell of the Bresenham line from `from` up to but without `to`.
void AddPasses(CellIndex from, CellIndex to, OccupancyGrid* grid) {
  const int dx = std::abs(to.x - from.x), dy = std::abs(to.y - from.y);
  const int step_x = from.x < to.x ? 1 : -1, step_y = from.y < to.y ? 1 : -1;
  int error = dx - dy;
  for (CellIndex at = from; at != to;) {
    grid->AddPass(at);
    const int twice = 2 * error;
    if (twice > -dy) {
      error -= dy;
      at.x += step_x;
    }
    if (twice < dx) {
      error += dx;
      at.y += step_y;
    }
  }
}

}  // namespace

void RegisterScan(const sensor::LaserScan& scan, const backend::SE2& world_T_robot,
                  const RegistrationOptions& options, OccupancyGrid* grid) {
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
    AddPasses(origin, {FloorToCell(end_x), FloorToCell(end_y)}, grid);
    if (hit) grid->AddHit(end_x, end_y);
  }
}

}  // namespace gmapping_spa::map
