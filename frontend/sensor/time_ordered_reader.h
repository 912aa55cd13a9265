// SPDX-License-Identifier: BSD-3-Clause
// Scans in the order of their stamps, each with odometry.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_TIME_ORDERED_READER_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_TIME_ORDERED_READER_H_

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_record.h"

namespace gmapping_spa::sensor {

// Loggers write records as they arrive, not as they were measured. A scan is held back until one
// that is options.reorder_window_s younger has come, so that disorder up to that gets mended, and
// until then ODOM records are collected to interpolate the pose of scans that come without one.
//
// A scan older than the window allows is late: the clock was set back, or a stamp is wrong. The
// policy kFail makes that an error. Under kSkip ordering starts afresh with the late scan, so that
// nothing is lost and what follows is in order again: stamps are ascending but for such steps.
class TimeOrderedReader {
 public:
  TimeOrderedReader(std::unique_ptr<RecordReader> source, std::string name,
                    const LogOptions& options);

  // The next scan, or nothing at the end. Scans are numbered (LaserScan::index) in the order of
  // the input. A scan that repeats another one of the same stamp, beam for beam, is the same sweep
  // in another record (RAWLASER1 and ROBOTLASER1): one of them is left out, the one without
  // odometry if there is such. Throws as the source does.
  std::optional<ScanRecord> Next();

  LogCounts counts() const;  // with those of the source

 private:
  void AddOdometry(const OdometryRecord& record);
  void AddScan(ScanRecord record);
  // Whether `record` is a sweep that is already held.
  bool MergeRepeated(ScanRecord& record);
  // Makes the earliest held scan ready.
  void ReleaseFirst();
  void ReleaseAll();
  void FillOdometry(ScanRecord& record);

  std::unique_ptr<RecordReader> source_;
  std::string name_;
  LogOptions options_;

  std::multimap<double, ScanRecord> held_;  // by stamp; equal stamps in input order
  std::deque<ScanRecord> ready_;
  std::map<double, backend::SE2> odometry_;  // odom_T_robot by stamp
  std::optional<double> newest_stamp_s_;     // of the scans since ordering last started afresh
  std::optional<double> previous_stamp_s_;   // of the scan before this one in the input

  std::int64_t num_scans_ = 0;
  std::int64_t num_out_of_order_ = 0;
  std::int64_t num_late_ = 0;
  std::int64_t num_repeated_ = 0;
  std::int64_t num_interpolated_ = 0;
  std::int64_t num_extrapolated_ = 0;
  std::int64_t num_without_odometry_ = 0;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_TIME_ORDERED_READER_H_
