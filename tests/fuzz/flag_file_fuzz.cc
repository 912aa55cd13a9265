// SPDX-License-Identifier: BSD-3-Clause
// Files of flags.
#include <gflags/gflags.h>

#include <cstddef>
#include <cstdint>

#include "experiments/apps/flag_files.h"
#include "tests/fuzz/contract.h"
#include "tests/fuzz/input_folder.h"

DEFINE_bool(switch_on, false, "A flag for files to set.");
DEFINE_double(size_m, 1.0, "Another one.");

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::InputFolder folder;
  const std::string path = folder.FileWith("run.flags", fuzz::TextOf(data, size));
  fuzz::ReadsOrRefuses([&] { apps::ReadFlagFiles({path}); });
  return 0;
}
