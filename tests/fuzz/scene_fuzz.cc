// SPDX-License-Identifier: BSD-3-Clause
// Files of obstacles, with a pedestrian that walks or stands, and files of way points.
#include <cstddef>
#include <cstdint>
#include <string>

#include "experiments/simulation/scene.h"
#include "experiments/simulation/way_point_follower.h"
#include "tests/fuzz/contract.h"
#include "tests/fuzz/input_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::InputFolder folder;
  static const std::string world = folder.FileWith("world.yaml", "size: [4, 4]\nresolution: 0.1\n");
  const std::string path = folder.FileWith("scene.yaml", fuzz::TextOf(data, size));
  for (const bool walks : {false, true}) {
    fuzz::ReadsOrRefuses([&] { simulation::Scene::Read(world, path, walks); });
  }
  fuzz::ReadsOrRefuses([&] { simulation::ReadTours(path); });
  return 0;
}
