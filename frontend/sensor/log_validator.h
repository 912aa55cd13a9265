// SPDX-License-Identifier: BSD-3-Clause
// Watches the stream of scans for what hints at a damaged log.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_LOG_VALIDATOR_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_LOG_VALIDATOR_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_reader.h"
#include "frontend/sensor/time_ordered_reader.h"

namespace gmapping_spa::sensor {

// Compares each scan with the one before it. Counts scans more than options.gap_s apart ("gaps"),
// with the same stamp ("duplicate_stamps") and with another number of beams
// ("changed_beam_counts"), and beams by status ("beams_hit", "beams_no_return", "beams_invalid").
// All of them are delivered under kSkip, as every one has its pose in the trajectory; under kFail
// the first of them is an error.
class LogValidator : public LogReader {
 public:
  LogValidator(TimeOrderedReader source, std::string name, const LogOptions& options);

  std::optional<LaserScan> Next() override;
  LogCounts counts() const override;

 private:
  void CompareWithPrevious(const ScanRecord& record);
  // Counts a finding, or throws it, as the policy wants.
  void Report(std::int64_t& count, std::int64_t line, const std::string& message);

  TimeOrderedReader source_;
  std::string name_;
  LogOptions options_;
  std::optional<double> previous_stamp_s_;
  std::size_t previous_num_beams_ = 0;

  std::int64_t num_scans_ = 0;
  std::int64_t num_hits_ = 0;
  std::int64_t num_no_returns_ = 0;
  std::int64_t num_invalid_ = 0;
  std::int64_t num_gaps_ = 0;
  std::int64_t num_duplicate_stamps_ = 0;
  std::int64_t num_changed_beam_counts_ = 0;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_LOG_VALIDATOR_H_
