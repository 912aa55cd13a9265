// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/robot_beam_filter.h"

#include <algorithm>
#include <cmath>

#include "backend/se2.h"

namespace gmapping_spa::sensor {
namespace {

constexpr double kLongest_m = 1.0;    // of a beam that may end on the robot
constexpr double kAlike_m = 0.03;     // how far readings of the same spot lie apart
constexpr double kChanged_m = 0.1;    // from here on a reading is of another spot
constexpr double kChangedPart = 0.7;  // of the beams that may change, in a scan that tests
constexpr double kAlikePart = 0.95;   // of the tests of a beam on the robot
constexpr std::int64_t kFewestTests = 30;
constexpr double kLeastTurn_rad = 1.0;

// The range; infinite without return, NaN when there is no reading.
double ReadingOf(const Beam& beam) {
  if (beam.status == BeamStatus::kHit) return beam.range_m;
  return beam.status == BeamStatus::kNoReturn ? HUGE_VAL : NAN;
}

double MedianReading(const std::vector<const LaserScan*>& scans, std::size_t beam) {
  std::vector<double> readings;
  for (const LaserScan* scan : scans) {
    const double reading = ReadingOf(scan->beams[beam]);
    if (!std::isnan(reading)) readings.push_back(reading);
  }
  if (2 * readings.size() <= scans.size()) return NAN;
  const auto middle = readings.begin() + static_cast<std::ptrdiff_t>(readings.size() / 2);
  std::nth_element(readings.begin(), middle, readings.end());
  return *middle;
}

}  // namespace

void RobotBeamFilter::Begin(const std::vector<const LaserScan*>& scans) {
  std::vector<const LaserScan*> alike;
  for (const LaserScan* scan : scans) {
    if (scan->beams.size() == scans.front()->beams.size()) alike.push_back(scan);
  }
  for (std::size_t k = 0; k < scans.front()->beams.size(); ++k) {
    usual_m_.push_back(MedianReading(alike, k));
    beams_.push_back({.usual_m = usual_m_[k] < kLongest_m ? usual_m_[k] : 0.0});
  }
}

void RobotBeamFilter::Test(const LaserScan& scan) {
  // Whether the robot looks elsewhere than usually: by the beams that may not be its own.
  int num_others = 0, num_changed = 0;
  const auto is_alike = [&](std::size_t k) {
    return std::abs(ReadingOf(scan.beams[k]) - usual_m_[k]) <= kAlike_m;
  };
  for (std::size_t k = 0; k < beams_.size(); ++k) {
    if (std::isnan(usual_m_[k]) || (beams_[k].usual_m > 0.0 && is_alike(k))) continue;
    const double reading = ReadingOf(scan.beams[k]);
    if (std::isnan(reading)) continue;
    ++num_others;
    if (std::isinf(reading) != std::isinf(usual_m_[k]) ||
        std::abs(reading - usual_m_[k]) > kChanged_m) {
      ++num_changed;
    }
  }
  if (num_others == 0 || num_changed < kChangedPart * num_others) return;
  const double heading_rad = scan.odom_T_robot.theta;
  if (num_tests_++ == 0) least_heading_rad_ = greatest_heading_rad_ = heading_rad;
  const double center_rad = 0.5 * (least_heading_rad_ + greatest_heading_rad_);
  const double unwrapped_rad = center_rad + backend::WrapAngle(heading_rad - center_rad);
  least_heading_rad_ = std::min(least_heading_rad_, unwrapped_rad);
  greatest_heading_rad_ = std::max(greatest_heading_rad_, unwrapped_rad);
  for (std::size_t k = 0; k < beams_.size(); ++k) {
    if (beams_[k].usual_m > 0.0 && is_alike(k)) ++beams_[k].num_alike;
  }
}

void RobotBeamFilter::Learn(const std::vector<const LaserScan*>& scans) {
  if (beams_.empty()) Begin(scans);
  for (const LaserScan* scan : scans) {
    if (scan->beams.size() == beams_.size()) Test(*scan);
  }
}

bool RobotBeamFilter::IsOnRobot(const BeamRecord& beam) const {
  return beam.usual_m > 0.0 && num_tests_ >= kFewestTests &&
         greatest_heading_rad_ - least_heading_rad_ >= kLeastTurn_rad &&
         static_cast<double>(beam.num_alike) >= kAlikePart * static_cast<double>(num_tests_);
}

std::int64_t RobotBeamFilter::Apply(LaserScan* scan) const {
  if (scan->beams.size() != beams_.size()) return 0;
  std::int64_t num_changed = 0;
  for (std::size_t k = 0; k < beams_.size(); ++k) {
    if (scan->beams[k].status != BeamStatus::kHit || !IsOnRobot(beams_[k])) continue;
    scan->beams[k] = {scan->beams[k].angle_rad, 0.0, BeamStatus::kInvalid};
    ++num_changed;
  }
  return num_changed;
}

}  // namespace gmapping_spa::sensor
