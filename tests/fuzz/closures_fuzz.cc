// SPDX-License-Identifier: BSD-3-Clause
// Tables of loop closures that somebody has edited.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "experiments/apps/closure_rows.h"
#include "tests/fuzz/contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  fuzz::ReadsOrRefuses([&] {
    std::istringstream in(fuzz::TextOf(data, size));
    apps::ReadClosureRows(in, "loop_closures.csv", 100);
  });
  return 0;
}
