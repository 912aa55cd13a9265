// SPDX-License-Identifier: BSD-3-Clause
// The YAML of a map, beside an image that is whole.
#include <cstddef>
#include <cstdint>
#include <string>

#include "frontend/map/map_server_io.h"
#include "tests/fuzz/contract.h"
#include "tests/fuzz/input_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::InputFolder folder;
  static const std::string image =
      folder.FileWith("map.pgm", std::string("P5\n2 2\n255\n") + "\xfe\xcd" + std::string(2, '\0'));
  const std::string path = folder.FileWith("map.yaml", fuzz::TextOf(data, size));
  fuzz::ReadsOrRefuses([&] { map::ReadMap(path); });
  return 0;
}
