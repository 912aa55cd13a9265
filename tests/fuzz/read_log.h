// SPDX-License-Identifier: BSD-3-Clause
// Logs and bags, through all readers that stand one on another.
#ifndef GMAPPING_SPA_TESTS_FUZZ_READ_LOG_H_
#define GMAPPING_SPA_TESTS_FUZZ_READ_LOG_H_

#include <cmath>
#include <memory>
#include <optional>

#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_reader.h"
#include "tests/fuzz/contract.h"

namespace gmapping_spa::fuzz {

// Reads to the end what `open(options)` opens, by both policies on bad records.
template <typename Open>
void ReadLog(const Open& open) {
  for (const auto policy : {sensor::BadRecordPolicy::kSkip, sensor::BadRecordPolicy::kFail}) {
    ReadsOrRefuses([&] {
      const std::unique_ptr<sensor::LogReader> log = open(sensor::LogOptions{.bad_record = policy});
      while (const std::optional<sensor::LaserScan> scan = log->Next()) {
        bool finite = std::isfinite(scan->stamp_s) && scan->robot_T_laser.IsFinite() &&
                      (!scan->has_odometry || scan->odom_T_robot.IsFinite());
        for (const sensor::Beam& beam : scan->beams) {
          finite = finite && std::isfinite(beam.angle_rad) && std::isfinite(beam.range_m);
        }
        if (!finite) Break("expected a scan of finite numbers");
      }
    });
  }
}

}  // namespace gmapping_spa::fuzz

#endif  // GMAPPING_SPA_TESTS_FUZZ_READ_LOG_H_
