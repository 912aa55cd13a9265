// SPDX-License-Identifier: BSD-3-Clause
// World files and the shapes in them.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/simulation/world.h"
#include "frontend/map/yaml_file.h"
#include "tests/fuzz/contract.h"
#include "tests/fuzz/input_folder.h"

namespace gmapping_spa::fuzz {
namespace {

// A world of more cells than this is right, and slow.
bool IsLarge(const std::string& path) {
  constexpr double kCells = 1e6;
  try {
    const map::YamlFile yaml(path);
    const std::vector<double> size = yaml.Numbers(yaml.Get("size"), 2, "a size");
    const double resolution_m = yaml.Number("resolution");
    return !(size[0] / resolution_m * (size[1] / resolution_m) <= kCells);
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace
}  // namespace gmapping_spa::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::InputFolder folder;
  static const std::string image =
      folder.FileWith("map.pgm", std::string("P5\n2 2\n255\n") + std::string(4, '\xfe'));
  const std::string path = folder.FileWith("world.yaml", fuzz::TextOf(data, size));
  if (fuzz::IsLarge(path)) return 0;
  fuzz::ReadsOrRefuses([&] { simulation::World(simulation::ReadWorldRaster(path)); });
  return 0;
}
