// SPDX-License-Identifier: BSD-3-Clause
// Relations of the benchmark by Kuemmerle et al.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "experiments/metrics/relations.h"
#include "tests/fuzz/contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  fuzz::ReadsOrRefuses([&] {
    std::istringstream in(fuzz::TextOf(data, size));
    metrics::ReadRelations(in, "relations");
  });
  return 0;
}
