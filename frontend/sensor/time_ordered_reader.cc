// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/time_ordered_reader.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace gmapping_spa::sensor {
namespace {

using backend::SE2;

// Bounds the memory where stamps do not advance. Far above the scans or odometry readings that come
// within seconds.
constexpr std::size_t kMaxHeld = 4096;

bool SameSweep(const ScanRecord& a, const ScanRecord& b) {
  if (a.has_odometry && b.has_odometry && a.scan.odom_T_robot != b.scan.odom_T_robot) return false;
  return std::ranges::equal(a.scan.beams, b.scan.beams, [](const Beam& p, const Beam& q) {
    return p.range_m == q.range_m && p.status == q.status;
  });
}

// The pose at `fraction` of a motion of constant velocity between two poses.
SE2 Interpolate(const SE2& from, const SE2& to, double fraction) {
  return from * backend::Exp(fraction * backend::Log(backend::Between(from, to)));
}

}  // namespace

TimeOrderedReader::TimeOrderedReader(std::unique_ptr<RecordReader> source, std::string name,
                                     const LogOptions& options)
    : source_(std::move(source)), name_(std::move(name)), options_(options) {}

std::optional<ScanRecord> TimeOrderedReader::Next() {
  while (ready_.empty()) {
    std::optional<LogRecord> record = source_->Next();
    if (!record) {
      ReleaseAll();
      break;
    }
    if (auto* scan = std::get_if<ScanRecord>(&*record)) {
      AddScan(std::move(*scan));
    } else {
      AddOdometry(std::get<OdometryRecord>(*record));
    }
  }
  if (ready_.empty()) return std::nullopt;
  ScanRecord scan = std::move(ready_.front());
  ready_.pop_front();
  return scan;
}

LogCounts TimeOrderedReader::counts() const {
  LogCounts counts = source_->counts();
  counts["out_of_order_scans"] = num_out_of_order_;
  counts["late_scans"] = num_late_;
  counts["repeated_scans"] = num_repeated_;
  counts["odometry_interpolated"] = num_interpolated_;
  counts["odometry_extrapolated"] = num_extrapolated_;
  counts["scans_without_odometry"] = num_without_odometry_;
  return counts;
}

void TimeOrderedReader::AddOdometry(const OdometryRecord& record) {
  odometry_[record.stamp_s] = record.odom_T_robot;
  if (odometry_.size() > kMaxHeld) odometry_.erase(odometry_.begin());
}

void TimeOrderedReader::AddScan(ScanRecord record) {
  const double stamp_s = record.scan.stamp_s;
  if (previous_stamp_s_ && stamp_s < *previous_stamp_s_) ++num_out_of_order_;
  previous_stamp_s_ = stamp_s;
  if (newest_stamp_s_ && stamp_s < *newest_stamp_s_ - options_.reorder_window_s) {
    if (options_.bad_record == BadRecordPolicy::kFail) {
      throw LogError(name_, record.line,
                     "expected a stamp within the reorder window, found one " +
                         std::to_string(*newest_stamp_s_ - stamp_s) + " s back");
    }
    ++num_late_;
    ReleaseAll();
    newest_stamp_s_.reset();
    // Odometry from before the clock went back would pass for that of the future.
    odometry_.erase(odometry_.upper_bound(stamp_s + options_.reorder_window_s), odometry_.end());
  }
  if (MergeRepeated(record)) return;
  record.scan.index = num_scans_++;
  held_.emplace(stamp_s, std::move(record));
  newest_stamp_s_ = std::max(newest_stamp_s_.value_or(stamp_s), stamp_s);
  while (held_.begin()->first < *newest_stamp_s_ - options_.reorder_window_s ||
         held_.size() > kMaxHeld) {
    ReleaseFirst();
  }
  // Scans to come need one reading before the first of them.
  const auto next = odometry_.upper_bound(held_.begin()->first);
  if (next != odometry_.begin()) odometry_.erase(odometry_.begin(), std::prev(next));
}

bool TimeOrderedReader::MergeRepeated(ScanRecord& record) {
  const auto [begin, end] = held_.equal_range(record.scan.stamp_s);
  for (auto it = begin; it != end; ++it) {
    ScanRecord& held = it->second;
    if (!SameSweep(held, record)) continue;
    ++num_repeated_;
    if (record.has_odometry && !held.has_odometry) {
      record.scan.index = held.scan.index;
      held = std::move(record);
    }
    return true;
  }
  return false;
}

void TimeOrderedReader::ReleaseFirst() {
  ready_.push_back(std::move(held_.begin()->second));
  held_.erase(held_.begin());
  FillOdometry(ready_.back());
}

void TimeOrderedReader::ReleaseAll() {
  while (!held_.empty()) ReleaseFirst();
}

void TimeOrderedReader::FillOdometry(ScanRecord& record) {
  if (record.has_odometry) return;
  if (odometry_.empty()) {
    ++num_without_odometry_;
    record.scan.has_odometry = false;
    return;
  }
  const double stamp_s = record.scan.stamp_s;
  const auto after = odometry_.lower_bound(stamp_s);
  if (after != odometry_.end() && after->first == stamp_s) {
    record.scan.odom_T_robot = after->second;
    ++num_interpolated_;
  } else if (after == odometry_.begin() || after == odometry_.end()) {
    const auto nearest = after == odometry_.end() ? std::prev(after) : after;
    record.scan.odom_T_robot = nearest->second;
    ++num_extrapolated_;
  } else {
    const auto before = std::prev(after);
    const double fraction = (stamp_s - before->first) / (after->first - before->first);
    record.scan.odom_T_robot = Interpolate(before->second, after->second, fraction);
    ++num_interpolated_;
  }
}

}  // namespace gmapping_spa::sensor
