// SPDX-License-Identifier: BSD-3-Clause
// Records as a CARMEN log.
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_CARMEN_SINK_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_CARMEN_SINK_H_

#include <optional>
#include <ostream>

#include "experiments/conversion/record_sink.h"

namespace gmapping_spa::conversion {

// Writes RAWLASER1 and ODOM records, and PARAM records where the mounting of the laser changes.
// Numbers have as many digits as it takes to read the same ones again.
class CarmenSink : public RecordSink {
 public:
  explicit CarmenSink(std::ostream& out);

  void OnScan(const sensor::ScanRecord& record) override;
  void OnOdometry(const sensor::OdometryRecord& record) override;
  void Finish() override {}
  Losses losses() const override;

 private:
  std::ostream& out_;
  std::optional<backend::SE2> robot_T_laser_;  // as written last
  std::int64_t num_sweeps_ = 0;
};

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_CARMEN_SINK_H_
