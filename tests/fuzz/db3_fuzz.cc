// SPDX-License-Identifier: BSD-3-Clause
// Databases of rosbag2.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/input_folder.h"
#include "tests/fuzz/read_bag.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::InputFolder folder;
  fuzz::ReadBag(folder.FileWith("log.db3", fuzz::TextOf(data, size)));
  return 0;
}
