// SPDX-License-Identifier: BSD-3-Clause
// Sensor logs: order, mounting, filters, validation.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>

#include "frontend/sensor/open_log.h"
#include "tests/fuzz/read_log.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  const std::string text = fuzz::TextOf(data, size);
  fuzz::ReadLog([&](const sensor::LogOptions& options) {
    return sensor::OpenCarmenLog(std::make_unique<std::istringstream>(text), "log.clf", options);
  });
  return 0;
}
