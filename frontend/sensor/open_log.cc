// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/open_log.h"

#include <utility>

#include "frontend/sensor/carmen_reader.h"
#include "frontend/sensor/log_pipeline.h"

namespace gmapping_spa::sensor {

std::unique_ptr<LogReader> OpenCarmenLog(std::unique_ptr<std::istream> in, const std::string& name,
                                         const LogOptions& options) {
  CheckOptions(options);
  return ScansOf(std::make_unique<CarmenReader>(std::move(in), name, options), name, options);
}

}  // namespace gmapping_spa::sensor
