// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "backend/out_of_memory.h"
#include "experiments/simulation/drawing.h"
#include "frontend/map/map_server_io.h"
#include "frontend/map/yaml_file.h"

namespace gmapping_spa::simulation {
namespace {

using map::CellState;
using map::TrinaryMap;

TrinaryMap EmptyRaster(const map::YamlFile& yaml) {
  TrinaryMap raster;
  raster.resolution_m = yaml.Number("resolution");
  const std::vector<double> size = yaml.Numbers(yaml.Get("size"), 2, "the size [x, y] in metres");
  const double width = size[0] / raster.resolution_m, height = size[1] / raster.resolution_m;
  if (!(raster.resolution_m > 0.0 && width >= 0.5 && height >= 0.5 &&
        width * height <= static_cast<double>(map::kMaxMapCells))) {
    yaml.Fail(yaml.Get("size"), "expected a size and a resolution of 1 to " +
                                    std::to_string(map::kMaxMapCells) + " cells");
  }
  raster.width = static_cast<int>(std::lround(width));
  raster.height = static_cast<int>(std::lround(height));
  backend::WithMemory("while reading " + yaml.path() + ": " +
                          backend::MemoryOfCells(raster.width, raster.height, 1),
                      [&] {
                        raster.cells.assign(static_cast<std::size_t>(raster.width) * raster.height,
                                            CellState::kFree);
                      });
  return raster;
}

// In two passes, each of which takes over from the neighbors that it has seen.
std::vector<std::uint8_t> Clearances(const TrinaryMap& raster) {
  constexpr int kMax = 255;
  std::vector<std::uint8_t> clearances(raster.cells.size());
  const auto at = [&](int column, int row) -> int {
    const bool inside = column >= 0 && column < raster.width && row >= 0 && row < raster.height;
    return inside ? clearances[static_cast<std::size_t>(row) * raster.width + column] : 0;
  };
  const auto set = [&](int column, int row, int value) {
    clearances[static_cast<std::size_t>(row) * raster.width + column] =
        static_cast<std::uint8_t>(value);
  };
  for (int row = 0; row < raster.height; ++row) {
    for (int column = 0; column < raster.width; ++column) {
      const bool solid = raster.at(column, row) == CellState::kOccupied;
      set(column, row,
          solid ? 0
                : std::min({at(column - 1, row), at(column - 1, row - 1), at(column, row - 1),
                            at(column + 1, row - 1), kMax - 1}) +
                      1);
    }
  }
  for (int row = raster.height - 1; row >= 0; --row) {
    for (int column = raster.width - 1; column >= 0; --column) {
      const int neighbors = std::min({at(column + 1, row), at(column + 1, row + 1),
                                      at(column, row + 1), at(column - 1, row + 1)});
      set(column, row, std::min(at(column, row), neighbors + 1));
    }
  }
  return clearances;
}

}  // namespace

World::World(TrinaryMap raster)
    : raster_(std::move(raster)),
      clearance_(backend::WithMemory(
          "while building the world: " + backend::MemoryOfCells(raster_.width, raster_.height, 2),
          [this] { return Clearances(raster_); })) {}

TrinaryMap ReadWorldRaster(const std::string& path) {
  const map::YamlFile yaml(path);
  const bool has_image = yaml.Has("image");
  if (has_image) {
    yaml.AllowOnly({"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh",
                    "mode", "boxes", "walls", "discs"});
  } else {
    yaml.AllowOnly({"size", "resolution", "boxes", "walls", "discs"});
  }
  TrinaryMap raster = has_image ? map::ReadMap(path) : EmptyRaster(yaml);
  DrawShapes(yaml, &raster);
  return raster;
}

Eigen::Vector2d World::ToCells(const Eigen::Vector2d& world_point) const {
  return (world_point - Eigen::Vector2d(raster_.origin_x_m, raster_.origin_y_m)) /
         raster_.resolution_m;
}

// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", Eurographics 1987, with
// the distance to each crossing computed anew, so that errors do not add up. Where all is clear the
// ray leaps, which leaves the crossings that follow as they are.
std::optional<double> World::CastRay(const Eigen::Vector2d& world_origin, double world_angle_rad,
                                     double max_range_m) const {
  const Eigen::Vector2d origin = ToCells(world_origin);
  const double dx = std::cos(world_angle_rad), dy = std::sin(world_angle_rad);
  const double max_range = max_range_m / raster_.resolution_m;
  if (!(origin.x() >= 0.0 && origin.x() < raster_.width && origin.y() >= 0.0 &&
        origin.y() < raster_.height)) {
    return std::nullopt;
  }
  int column = static_cast<int>(origin.x()), row = static_cast<int>(origin.y());
  const int step_x = dx > 0.0 ? 1 : -1, step_y = dy > 0.0 ? 1 : -1;
  const int edge_x = dx > 0.0 ? 1 : 0, edge_y = dy > 0.0 ? 1 : 0;
  // A ray along one axis never crosses an edge of the other.
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double per_dx = 1.0 / dx, per_dy = 1.0 / dy;
  const auto crossing_x = [&] {
    return dx == 0.0 ? kNever : (column + edge_x - origin.x()) * per_dx;
  };
  const auto crossing_y = [&] { return dy == 0.0 ? kNever : (row + edge_y - origin.y()) * per_dy; };

  const double per_step = 1.0 / std::max(std::abs(dx), std::abs(dy));
  double range = 0.0, next_x = crossing_x(), next_y = crossing_y();
  // Never back: a ray along an edge, off it by less than rounding, crosses it again and again.
  while (range <= max_range) {
    const int clearance = ClearanceAt(column, row);
    if (clearance == 0) return range * raster_.resolution_m;
    if (clearance > 2) {
      // Half a cell less than what is clear, so that rounding cannot lead out of it.
      range += (clearance - 1.5) * per_step;
      column = static_cast<int>(origin.x() + range * dx);
      row = static_cast<int>(origin.y() + range * dy);
      next_x = crossing_x();
      next_y = crossing_y();
    } else if (next_x < next_y) {
      range = std::max(range, next_x);
      column += step_x;
      if (column < 0 || column >= raster_.width) break;
      next_x = crossing_x();
    } else {
      range = std::max(range, next_y);
      row += step_y;
      if (row < 0 || row >= raster_.height) break;
      next_y = crossing_y();
    }
  }
  return std::nullopt;
}

std::optional<Eigen::Vector2d> World::FindContact(const Eigen::Vector2d& world_center,
                                                  double radius_m) const {
  const Eigen::Vector2d center = ToCells(world_center);
  const double radius = radius_m / raster_.resolution_m;
  const auto to_world = [this](const Eigen::Vector2d& cells) -> Eigen::Vector2d {
    return cells * raster_.resolution_m + Eigen::Vector2d(raster_.origin_x_m, raster_.origin_y_m);
  };
  const Eigen::Vector2d limit(raster_.width, raster_.height);
  for (const int axis : {0, 1}) {
    Eigen::Vector2d outside = center;
    outside[axis] = center[axis] < limit[axis] / 2.0 ? 0.0 : limit[axis];
    const bool beyond = center[axis] < radius || center[axis] > limit[axis] - radius;
    if (beyond) return to_world(outside);
  }
  const Eigen::Vector2i first = (center.array() - radius).floor().cast<int>().max(0);
  const Eigen::Vector2i last = (center.array() + radius).floor().cast<int>();
  std::optional<Eigen::Vector2d> contact;
  double best = radius * radius;
  for (int row = first.y(); row <= std::min(last.y(), raster_.height - 1); ++row) {
    for (int column = first.x(); column <= std::min(last.x(), raster_.width - 1); ++column) {
      if (!IsSolid(column, row)) continue;
      const Eigen::Vector2d point(std::clamp(center.x(), column + 0.0, column + 1.0),
                                  std::clamp(center.y(), row + 0.0, row + 1.0));
      if ((point - center).squaredNorm() >= best) continue;
      best = (point - center).squaredNorm();
      contact = to_world(point);
    }
  }
  return contact;
}

}  // namespace gmapping_spa::simulation
