// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/laser_mounting.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace gmapping_spa::sensor {
namespace {

using backend::Between;
using backend::SE2;

// Poses are written with a few decimals; a laser really mounted elsewhere differs by more.
constexpr double kTolerance = 1e-2;  // m and rad
constexpr int kEnoughScans = 100, kMostScans = 1000;
constexpr std::size_t kMostRecords = 4096;  // bounds the memory where scans are rare
// Robots are smaller; farther off, the laser pose is that of another frame.
constexpr double kLongestOffsetM = 2.0;
// A robot that has not turned tells no mounting from an offset between frames.
constexpr double kTurnedRad = 0.3;

bool Agree(const SE2& a, const SE2& b, double tolerance) {
  const SE2 difference = Between(a, b);
  return difference.translation().norm() <= tolerance && std::abs(difference.theta) <= tolerance;
}

// Collects the mountings that laser poses tell.
class Evidence {
 public:
  // Whether more of it could still change the verdict.
  bool WantsMore() const {
    return consistent_ && num_scans_ < (turned_ ? kEnoughScans : kMostScans);
  }

  void Add(const ScanRecord& record) {
    const SE2& robot_T_laser = *record.told_robot_T_laser;
    if (num_scans_ == 0) {
      first_robot_T_laser_ = robot_T_laser;
      first_odom_T_robot_ = record.scan.odom_T_robot;
      consistent_ = !Agree({}, robot_T_laser, kTolerance) &&
                    robot_T_laser.translation().norm() <= kLongestOffsetM;
    }
    ++num_scans_;
    // Both ends of the comparison are rounded.
    consistent_ = consistent_ && Agree(first_robot_T_laser_, robot_T_laser, 2.0 * kTolerance);
    const SE2 difference = Between(first_robot_T_laser_, robot_T_laser);
    sum_ = {sum_.x + difference.x, sum_.y + difference.y, sum_.theta + difference.theta};
    const SE2 motion = Between(first_odom_T_robot_, record.scan.odom_T_robot);
    turned_ = turned_ || std::abs(motion.theta) > kTurnedRad;
  }

  // The mean, in which rounding cancels out.
  std::optional<SE2> Verdict() const {
    if (num_scans_ == 0 || !consistent_) return std::nullopt;
    return first_robot_T_laser_ *
           SE2{sum_.x / num_scans_, sum_.y / num_scans_, sum_.theta / num_scans_};
  }

 private:
  bool consistent_ = true;
  bool turned_ = false;
  int num_scans_ = 0;
  SE2 first_robot_T_laser_, first_odom_T_robot_;
  SE2 sum_;  // of the differences from the first
};

}  // namespace

LaserMountingReader::LaserMountingReader(std::unique_ptr<RecordReader> source)
    : source_(std::move(source)) {}

std::optional<LogRecord> LaserMountingReader::Next() {
  if (!decided_ && held_.empty()) Decide();
  std::optional<LogRecord> record;
  if (held_.empty()) {
    record = source_->Next();
  } else {
    record = std::move(held_.front());
    held_.pop_front();
  }
  if (record) {
    if (auto* scan = std::get_if<ScanRecord>(&*record)) Finish(scan);
  }
  return record;
}

void LaserMountingReader::Decide() {
  Evidence evidence;
  while (evidence.WantsMore() && held_.size() < kMostRecords) {
    std::optional<LogRecord> record = source_->Next();
    if (!record) break;
    const auto* scan = std::get_if<ScanRecord>(&*record);
    const bool tells = scan != nullptr && scan->told_robot_T_laser && !scan->mounting_is_known;
    if (tells) evidence.Add(*scan);
    held_.push_back(std::move(*record));
    if (!tells && held_.size() == 1) return;  // nothing to compare yet, nothing to hold back
  }
  decided_ = true;
  robot_T_laser_ = evidence.Verdict();
}

void LaserMountingReader::Finish(ScanRecord* record) {
  if (!record->told_robot_T_laser) return;
  if (!record->mounting_is_known) {
    record->scan.robot_T_laser = robot_T_laser_.value_or(SE2{});
    num_used_ += robot_T_laser_ ? 1 : 0;
  }
  if (!Agree(record->scan.robot_T_laser, *record->told_robot_T_laser,
             robot_T_laser_ ? 2.0 * kTolerance : kTolerance)) {
    ++num_mismatches_;
  }
}

LogCounts LaserMountingReader::counts() const {
  LogCounts counts = source_->counts();
  counts["laser_pose_used"] = num_used_;
  counts["laser_pose_mismatches"] = num_mismatches_;
  return counts;
}

}  // namespace gmapping_spa::sensor
