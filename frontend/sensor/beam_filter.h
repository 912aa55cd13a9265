// SPDX-License-Identifier: BSD-3-Clause
// Rules about beams that show only over many scans.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_BEAM_FILTER_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_BEAM_FILTER_H_

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "frontend/sensor/log_record.h"

namespace gmapping_spa::sensor {

class BeamFilter {
 public:
  virtual ~BeamFilter() = default;
  // Learns from the next scans of the log.
  virtual void Learn(const std::vector<const LaserScan*>& scans) = 0;
  // Changes the status of beams of the scan, by what was learned so far; returns of how many.
  virtual std::int64_t Apply(LaserScan* scan) const = 0;
  // Name of the count of those beams.
  virtual const char* count_name() const = 0;
};

// Holds back 200 scans at a time, so that filters have learned from a scan before they change it.
class BeamFilterReader : public RecordReader {
 public:
  BeamFilterReader(std::unique_ptr<RecordReader> source,
                   std::vector<std::unique_ptr<BeamFilter>> filters);

  std::optional<LogRecord> Next() override;
  LogCounts counts() const override;  // those of the source, and of each filter

 private:
  // Reads the next scans, and all records between them.
  void Fill();

  std::unique_ptr<RecordReader> source_;
  std::vector<std::unique_ptr<BeamFilter>> filters_;
  std::vector<std::int64_t> num_changed_;  // by each filter
  std::deque<LogRecord> held_;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_BEAM_FILTER_H_
