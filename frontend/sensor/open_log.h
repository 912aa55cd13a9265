// SPDX-License-Identifier: BSD-3-Clause
// Opening sensor logs.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_OPEN_LOG_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_OPEN_LOG_H_

#include <istream>
#include <memory>
#include <string>

#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::sensor {

// Reads a CARMEN log: scans in the order of their ipc time stamps, each with odometry, beam angles
// and beam status. `name` stands for the log in messages. Let `in` throw on badbit
// (std::ios::exceptions) to have the cause of read errors told. Throws std::invalid_argument on
// options out of their range. A log without any scan is an error at the first Next().
std::unique_ptr<LogReader> OpenCarmenLog(std::unique_ptr<std::istream> in, const std::string& name,
                                         const LogOptions& options);

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_OPEN_LOG_H_
