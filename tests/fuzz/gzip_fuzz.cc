// SPDX-License-Identifier: BSD-3-Clause
// Files that may be gzipped.
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <vector>

#include "experiments/apps/input_file.h"
#include "tests/fuzz/contract.h"
#include "tests/fuzz/input_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::InputFolder folder;
  const std::string path = folder.FileWith("log.gz", fuzz::TextOf(data, size));
  fuzz::ReadsOrRefuses([&] {
    const std::unique_ptr<std::istream> in = apps::OpenInput(path);
    std::vector<char> buffer(1 << 16);
    while (in->read(buffer.data(), static_cast<std::streamsize>(buffer.size()))) {
    }
  });
  return 0;
}
