// SPDX-License-Identifier: BSD-3-Clause
// The image of a map: PGM, PPM, PNG.
#include <cstddef>
#include <cstdint>
#include <string>

#include "frontend/map/map_server_io.h"
#include "tests/fuzz/contract.h"
#include "tests/fuzz/input_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::InputFolder folder;
  static const std::string yaml = folder.FileWith(
      "map.yaml",
      "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\n");
  folder.FileWith("map.pgm", fuzz::TextOf(data, size));
  fuzz::ReadsOrRefuses([&] { map::ReadMap(yaml); });
  return 0;
}
