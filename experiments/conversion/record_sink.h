// SPDX-License-Identifier: BSD-3-Clause
// What takes in the records of a log to write them in another format.
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_RECORD_SINK_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_RECORD_SINK_H_

#include <cstdint>
#include <map>
#include <string>

#include "frontend/sensor/log_record.h"

namespace gmapping_spa::conversion {

// What the format cannot hold, by a line for people, and of how many records that was lost.
using Losses = std::map<std::string, std::int64_t>;

class RecordSink {
 public:
  virtual ~RecordSink() = default;
  virtual void OnScan(const sensor::ScanRecord& record) = 0;
  virtual void OnOdometry(const sensor::OdometryRecord& record) = 0;
  // After the last record.
  virtual void Finish() = 0;
  virtual Losses losses() const { return {}; }
};

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_RECORD_SINK_H_
