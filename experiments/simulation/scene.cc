// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/scene.h"

#include <stdexcept>
#include <vector>

#include "experiments/simulation/drawing.h"
#include "frontend/map/yaml_file.h"

namespace gmapping_spa::simulation {
namespace {

Pedestrian ReadPedestrian(const map::YamlFile& yaml) {
  Pedestrian pedestrian;
  const YAML::Node size = yaml.Get("pedestrian_size");
  const std::vector<double> size_m =
      yaml.Numbers(size, 2, "the size of a pedestrian [back to front, shoulder to shoulder]");
  if (!(size_m[0] > 0.0 && size_m[1] > 0.0)) {
    yaml.Fail(size, "expected the size of a pedestrian above 0");
  }
  pedestrian.size_m = {size_m[0], size_m[1]};
  pedestrian.speed_m_s = yaml.Number("pedestrian_speed");
  if (pedestrian.speed_m_s < 0.0) {
    yaml.Fail(yaml.Get("pedestrian_speed"), "expected the speed of a pedestrian, 0 or more");
  }
  pedestrian.way_points = ReadWayPoints(yaml, "pedestrian_way_points");
  return pedestrian;
}

}  // namespace

Scene Scene::Read(const std::string& world_path, const std::string& obstacles_path,
                  bool pedestrian_walks) {
  map::TrinaryMap raster = ReadWorldRaster(world_path);
  if (obstacles_path.empty()) {
    if (pedestrian_walks) {
      throw std::runtime_error("walking pedestrian: expected a file of obstacles, found none");
    }
    return World(std::move(raster));
  }
  const map::YamlFile yaml(obstacles_path);
  yaml.AllowOnly(
      {"boxes", "walls", "discs", "pedestrian_size", "pedestrian_speed", "pedestrian_way_points"});
  DrawShapes(yaml, &raster);
  const bool has_pedestrian = pedestrian_walks || yaml.Has("pedestrian_size") ||
                              yaml.Has("pedestrian_speed") || yaml.Has("pedestrian_way_points");
  if (!has_pedestrian) return World(std::move(raster));
  const Pedestrian pedestrian = ReadPedestrian(yaml);
  if (pedestrian_walks) return {World(std::move(raster)), pedestrian};
  if (!Draw(pedestrian.At(0.0), &raster)) {
    yaml.Fail(yaml.Get("pedestrian_way_points"), "expected a cell of the world in the pedestrian");
  }
  return World(std::move(raster));
}

template <typename Use>
void Scene::ForEachWalker(double time_s, const Use& use) const {
  if (pedestrian) use(pedestrian->At(time_s), "the pedestrian");
  for (const Walk& walk : crowd) {
    if (const std::optional<Rectangle> walker = walk.At(time_s)) use(*walker, "a walker");
  }
}

std::optional<double> Scene::CastRay(const Eigen::Vector2d& world_origin, double world_angle_rad,
                                     double max_range_m, double time_s) const {
  std::optional<double> walker_m;
  double nearest_m = max_range_m;
  ForEachWalker(time_s, [&](const Rectangle& walker, const char* /*what*/) {
    const std::optional<double> range_m = walker.CastRay(world_origin, world_angle_rad);
    if (range_m && *range_m <= nearest_m) walker_m = nearest_m = *range_m;
  });
  const std::optional<double> wall_m = world.CastRay(world_origin, world_angle_rad, nearest_m);
  return wall_m ? wall_m : walker_m;
}

std::optional<Contact> Scene::FindContact(const Eigen::Vector2d& world_center, double radius_m,
                                          double time_s) const {
  if (const auto point = world.FindContact(world_center, radius_m)) return {{*point, "a wall"}};
  std::optional<Contact> contact;
  ForEachWalker(time_s, [&](const Rectangle& walker, const char* what) {
    const Eigen::Vector2d point = walker.Nearest(world_center);
    if (!contact && (point - world_center).norm() < radius_m) contact = {point, what};
  });
  return contact;
}

}  // namespace gmapping_spa::simulation
