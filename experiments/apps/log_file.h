// SPDX-License-Identifier: BSD-3-Clause
// Sensor logs of any format.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_LOG_FILE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_LOG_FILE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "experiments/apps/json.h"
#include "frontend/rosbag/open_bag.h"
#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::apps {

struct LogFile {
  std::unique_ptr<sensor::LogReader> reader;
  std::shared_ptr<const rosbag::BagReport> bag;  // none for a CARMEN log
  // The count of the reader that tells how far it is.
  std::string progress_count;
  std::optional<std::int64_t> total = {};  // of that count, where it is known beforehand
};

// Tells the format by what is in the file: a bag of ROS 1 or ROS 2, a folder with such, or else a
// CARMEN log, plain or gzipped. Throws std::runtime_error with one line.
LogFile OpenLogFile(const std::string& path, const sensor::LogOptions& options);

// What its progress_count will be at the end, to tell the progress.
std::int64_t ProgressTotal(const LogFile& log, const std::string& path);

// {"sha256", "bytes"} of the file; {"files": [{"name", "sha256", "bytes"}, ...]} of a folder.
Json IdentifyLog(const std::string& path);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_LOG_FILE_H_
