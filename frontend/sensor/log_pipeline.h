// SPDX-License-Identifier: BSD-3-Clause
// What every log goes through, whatever its format is.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_LOG_PIPELINE_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_LOG_PIPELINE_H_

#include <memory>
#include <string>

#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_reader.h"
#include "frontend/sensor/log_record.h"

namespace gmapping_spa::sensor {

// Throws std::invalid_argument on options out of their range.
void CheckOptions(const LogOptions& options);

// The scans of a log in the order of their stamps, each with mounting, odometry and beams whose
// status is known (README.md of this folder). `name` stands for the log in messages.
std::unique_ptr<LogReader> ScansOf(std::unique_ptr<RecordReader> records, const std::string& name,
                                   const LogOptions& options);

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_LOG_PIPELINE_H_
