// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/drawing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace gmapping_spa::simulation {
namespace {

using map::CellState;
using map::TrinaryMap;

template <typename Shape>
bool DrawShape(const Shape& shape, TrinaryMap* raster) {
  const Eigen::Vector2d extent = shape.HalfExtent();
  if (!shape.center().allFinite() || !extent.allFinite()) return false;  // absurdly large
  const Eigen::Vector2d origin(raster->origin_x_m, raster->origin_y_m);
  const Eigen::Vector2d size(raster->width, raster->height);
  const auto cell_at = [&](const Eigen::Vector2d& world_point) -> Eigen::Vector2i {
    const Eigen::Vector2d cell = (world_point - origin) / raster->resolution_m;
    return cell.cwiseMax(0.0).cwiseMin(size).cast<int>();
  };
  const Eigen::Vector2i first = cell_at(shape.center() - extent);
  const Eigen::Vector2i last = cell_at(shape.center() + extent);
  bool drew = false;
  for (int row = first.y(); row <= std::min(last.y(), raster->height - 1); ++row) {
    for (int column = first.x(); column <= std::min(last.x(), raster->width - 1); ++column) {
      // Edges of shapes often fall on those of cells: half a cell away from any center, so that
      // rounding does not move them.
      const Eigen::Vector2d center =
          origin + raster->resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      if (!shape.Contains(center)) continue;
      raster->at(column, row) = CellState::kOccupied;
      drew = true;
    }
  }
  return drew;
}

}  // namespace

bool Draw(const Rectangle& rectangle, TrinaryMap* raster) { return DrawShape(rectangle, raster); }

bool Draw(const Disc& disc, TrinaryMap* raster) { return DrawShape(disc, raster); }

void DrawShapes(const map::YamlFile& yaml, TrinaryMap* raster) {
  const auto draw_all = [&](const char* key, std::size_t numbers, const char* what,
                            const char* conditions, const auto& shape_of) {
    if (!yaml.Has(key)) return;
    for (const YAML::Node& item : yaml.Items(key)) {
      if (!Draw(shape_of(yaml.Numbers(item, numbers, what)), raster)) {
        yaml.Fail(item, std::string("expected ") + conditions + " and a cell of the world in it");
      }
    }
  };
  draw_all("boxes", 4, "a box [x_min, y_min, x_max, y_max]", "x_min < x_max, y_min < y_max",
           [](const std::vector<double>& box) {
             return Rectangle::FromCorners({box[0], box[1]}, {box[2], box[3]});
           });
  draw_all("walls", 5, "a wall [x1, y1, x2, y2, thickness]", "a thickness above 0",
           [](const std::vector<double>& wall) {
             const Eigen::Vector2d from(wall[0], wall[1]), to(wall[2], wall[3]);
             const Eigen::Vector2d center = (from + to) / 2.0, along = to - from;
             return Rectangle{{center.x(), center.y(), std::atan2(along.y(), along.x())},
                              {along.norm() / 2.0, wall[4] / 2.0}};
           });
  draw_all("discs", 3, "a disc [x, y, radius]", "a radius above 0",
           [](const std::vector<double>& disc) {
             return Disc{{disc[0], disc[1]}, disc[2]};
           });
}

}  // namespace gmapping_spa::simulation
