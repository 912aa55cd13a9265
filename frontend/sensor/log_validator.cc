// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/log_validator.h"

#include <utility>

namespace gmapping_spa::sensor {

LogValidator::LogValidator(TimeOrderedReader source, std::string name, const LogOptions& options)
    : source_(std::move(source)), name_(std::move(name)), options_(options) {}

std::optional<LaserScan> LogValidator::Next() {
  std::optional<ScanRecord> record = source_.Next();
  if (!record) return std::nullopt;
  if (previous_stamp_s_) CompareWithPrevious(*record);
  previous_stamp_s_ = record->scan.stamp_s;
  previous_num_beams_ = record->scan.beams.size();
  ++num_scans_;
  for (const Beam& beam : record->scan.beams) {
    ++(beam.status == BeamStatus::kHit        ? num_hits_
       : beam.status == BeamStatus::kNoReturn ? num_no_returns_
                                              : num_invalid_);
  }
  return std::move(record->scan);
}

LogCounts LogValidator::counts() const {
  LogCounts counts = source_.counts();
  counts["scans"] = num_scans_;
  counts["beams_hit"] = num_hits_;
  counts["beams_no_return"] = num_no_returns_;
  counts["beams_invalid"] = num_invalid_;
  counts["gaps"] = num_gaps_;
  counts["duplicate_stamps"] = num_duplicate_stamps_;
  counts["changed_beam_counts"] = num_changed_beam_counts_;
  return counts;
}

void LogValidator::CompareWithPrevious(const ScanRecord& record) {
  const double step_s = record.scan.stamp_s - *previous_stamp_s_;
  const std::size_t num_beams = record.scan.beams.size();
  if (step_s > options_.gap_s) {
    Report(num_gaps_, record.line,
           "expected the next scan within " + std::to_string(options_.gap_s) + " s, found it " +
               std::to_string(step_s) + " s later");
  }
  if (step_s == 0.0) {
    Report(num_duplicate_stamps_, record.line,
           "expected a stamp of its own, found that of another scan");
  }
  if (num_beams != previous_num_beams_) {
    Report(num_changed_beam_counts_, record.line,
           "expected " + std::to_string(previous_num_beams_) + " beams as before, found " +
               std::to_string(num_beams));
  }
}

void LogValidator::Report(std::int64_t& count, std::int64_t line, const std::string& message) {
  if (options_.bad_record == BadRecordPolicy::kFail) throw LogError(name_, line, message);
  ++count;
}

}  // namespace gmapping_spa::sensor
