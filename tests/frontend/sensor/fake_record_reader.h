// SPDX-License-Identifier: BSD-3-Clause
// Records made up by a test.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_SENSOR_FAKE_RECORD_READER_H_
#define GMAPPING_SPA_TESTS_FRONTEND_SENSOR_FAKE_RECORD_READER_H_

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "frontend/sensor/log_record.h"

namespace gmapping_spa::sensor {

class FakeRecordReader : public RecordReader {
 public:
  explicit FakeRecordReader(std::vector<LogRecord> records) : records_(std::move(records)) {}

  std::optional<LogRecord> Next() override {
    if (position_ == records_.size()) return std::nullopt;
    LogRecord record = records_[position_++];
    if (auto* scan = std::get_if<ScanRecord>(&record)) {
      scan->line = static_cast<std::int64_t>(position_);
    }
    return record;
  }

  LogCounts counts() const override { return {{"of_the_source", 7}}; }

  std::size_t position() const { return position_; }

 private:
  std::vector<LogRecord> records_;
  std::size_t position_ = 0;
};

inline ScanRecord ScanWithOdometry(double stamp_s, const std::vector<double>& ranges_m = {1.0},
                                   const backend::SE2& odom_T_robot = {}) {
  ScanRecord record;
  record.has_odometry = true;
  record.scan.stamp_s = stamp_s;
  record.scan.odom_T_robot = odom_T_robot;
  for (const double range_m : ranges_m) {
    record.scan.beams.push_back({0.0, range_m, BeamStatus::kHit});
  }
  return record;
}

inline ScanRecord ScanWithoutOdometry(double stamp_s, const std::vector<double>& ranges_m = {1.0}) {
  ScanRecord record = ScanWithOdometry(stamp_s, ranges_m);
  record.has_odometry = false;
  return record;
}

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_TESTS_FRONTEND_SENSOR_FAKE_RECORD_READER_H_
