// SPDX-License-Identifier: BSD-3-Clause
// Sensor logs, through all readers that stand one on another: order, mounting, filters, validation.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>

#include "frontend/sensor/open_log.h"
#include "tests/fuzz/contract.h"

namespace gmapping_spa::fuzz {
namespace {

void ReadLog(const std::string& text, const sensor::LogOptions& options) {
  const auto log =
      sensor::OpenCarmenLog(std::make_unique<std::istringstream>(text), "log.clf", options);
  while (const std::optional<sensor::LaserScan> scan = log->Next()) {
    bool finite = std::isfinite(scan->stamp_s) && scan->robot_T_laser.IsFinite() &&
                  (!scan->has_odometry || scan->odom_T_robot.IsFinite());
    for (const sensor::Beam& beam : scan->beams) {
      finite = finite && std::isfinite(beam.angle_rad) && std::isfinite(beam.range_m);
    }
    if (!finite) Break("expected a scan of finite numbers");
  }
}

}  // namespace
}  // namespace gmapping_spa::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  const std::string text = fuzz::TextOf(data, size);
  sensor::LogOptions options;
  for (const auto policy : {sensor::BadRecordPolicy::kSkip, sensor::BadRecordPolicy::kFail}) {
    options.bad_record = policy;
    fuzz::ReadsOrRefuses([&] { fuzz::ReadLog(text, options); });
  }
  return 0;
}
