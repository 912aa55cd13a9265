// SPDX-License-Identifier: BSD-3-Clause
// Files of sessions.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "frontend/session/session_file.h"
#include "tests/fuzz/contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  std::istringstream in(fuzz::TextOf(data, size));
  fuzz::ReadsOrRefuses([&] { session::ReadSession(&in, "session"); });
  return 0;
}
