// SPDX-License-Identifier: BSD-3-Clause
// A two-dimensional world of solid and empty cells.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_WORLD_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_WORLD_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::simulation {

// Reads a world file: YAML with the keys of map_server for an image, or `size: [x, y]` and
// `resolution` in metres for an empty world with its lower left corner at the origin; either may
// have shapes drawn over it (drawing.h).
// Throws std::runtime_error "<path>[:<line>]: <what was expected, what was found>".
map::TrinaryMap ReadWorldRaster(const std::string& path);

// A raster in which occupied cells are solid and all others empty. Outside of it there is nothing
// to see and nowhere to drive. Coordinates are in the world frame, in metres.
class World {
 public:
  explicit World(map::TrinaryMap raster);

  // Distance along the ray to where it enters the first solid cell; nothing when that is farther
  // than max_range_m or never happens. Exact for the raster (to rounding), 0 from inside a solid.
  std::optional<double> CastRay(const Eigen::Vector2d& world_origin, double world_angle_rad,
                                double max_range_m) const;

  // The point of a solid cell nearest to the center, or a point of the edge of the world, that lies
  // in the disc; nothing when the disc is free.
  std::optional<Eigen::Vector2d> FindContact(const Eigen::Vector2d& world_center,
                                             double radius_m) const;

  const map::TrinaryMap& raster() const { return raster_; }

 private:
  int ClearanceAt(int column, int row) const {
    return clearance_[static_cast<std::size_t>(row) * raster_.width + column];
  }
  bool IsSolid(int column, int row) const { return ClearanceAt(column, row) == 0; }
  // In units of cells, from the lower left corner.
  Eigen::Vector2d ToCells(const Eigen::Vector2d& world_point) const;

  map::TrinaryMap raster_;
  // Of each cell: all cells fewer columns and rows away are empty and within the raster. 0: solid.
  std::vector<std::uint8_t> clearance_;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_WORLD_H_
