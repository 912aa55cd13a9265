// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sweep_duration.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "frontend/map/scan_insertion.h"
#include "frontend/scan_matching/scan_points.h"
#include "frontend/scan_matching/sweep_fit.h"
#include "frontend/sensor/deskew.h"

namespace gmapping_spa::frontend {

using backend::SE2;
using scan_matching::SweepFit;

namespace {

// How fast a robot moves, rad/s: a metre at this distance counts as a radian.
constexpr double kDistance_m = 2.0;
constexpr double kStraight = 0.15;  // turns slower than this bend little, and alike for long
constexpr double kFaster = 0.35;    // turns than the reference: the scan may show the duration
constexpr double kSteady = 0.6;     // part by which the velocity may change in an interval
constexpr double kLongest_s = 1.5;  // since the reference
// Durations to begin with: up to the time between two scans, within limits. Common lasers turn
// 5 times a second or more.
constexpr double kStep_s = 0.025;
constexpr double kUsualSweep_s = 0.2;
constexpr double kLongestSweep_s = 0.6;

// A measurement counts when so many beams, as a part of all, fit, and its standard deviation is at
// most this, or that part of it; beams side by side are off together.
constexpr double kFits = 0.4;
constexpr double kBeamsThatCountAsOne = 20.0;
constexpr double kMaxSigma_s = 0.05;
constexpr double kMaxSigma = 0.5;
constexpr double kMostInformation = kBeamsThatCountAsOne / (0.01 * 0.01);

// A duration is the median of so many measurements, and proven by so many that agree and are
// together so sure.
constexpr std::size_t kMeasurements = 31;
constexpr int kOneIn = 15;  // chances to measure is taken when there are that many
constexpr std::size_t kProvenBy = 3;
constexpr double kSure = 1.5;          // standard deviations from zero
constexpr double kAgreeing = 0.7;      // part of the measurements
constexpr double kDisproving = 0.5;    // with a lower part that agrees, it was chance
constexpr double kShortest_s = 0.015;  // shorter ones bend no scan that a map would show
constexpr double kFarOff_s = 0.03;     // what is told is more exact than what is measured

double Speed(const Eigen::Vector3d& velocity) {
  return velocity.head<2>().norm() / kDistance_m + std::abs(velocity.z());
}

}  // namespace

double SweepDuration::WeightedMedian(std::deque<Measurement> measurements) {
  std::sort(measurements.begin(), measurements.end(),
            [](const Measurement& a, const Measurement& b) { return a.sweep_s < b.sweep_s; });
  double left = 0.0;
  for (const Measurement& measurement : measurements) left += 0.5 * measurement.information;
  for (const Measurement& measurement : measurements) {
    left -= measurement.information;
    if (left <= 0.0) return measurement.sweep_s;
  }
  return 0.0;
}

SweepDuration::SweepDuration(const map::OccupancyGrid::Options& grid,
                             const scan_matching::GaussNewton::Options& gauss_newton,
                             const std::optional<double>& known_s)
    : grid_options_(grid),
      gauss_newton_(gauss_newton),
      is_known_(known_s.has_value()),
      value_s_(known_s.value_or(0.0)) {}

void SweepDuration::Tell(double sweep_s) {
  if (is_known_) return;
  told_s_ = sweep_s;
  if (!is_proven_) value_s_ = told_s_;
}

void SweepDuration::Learn(const sensor::LaserScan& scan, const SE2& odom_T_robot,
                          const Eigen::Vector3d& velocity) {
  if (is_known_) return;
  if (!latest_.scan.beams.empty()) {
    const double change = Speed(velocity - latest_.velocity);
    latest_.velocity = 0.5 * (latest_.velocity + velocity);
    const double speed = Speed(latest_.velocity);
    const double turn_rad_s = std::abs(latest_.velocity.z());
    if (!straight_.at.scan.beams.empty() && change < kSteady * speed &&
        turn_rad_s > std::abs(straight_.at.velocity.z()) + kFaster &&
        latest_.scan.stamp_s - straight_.at.scan.stamp_s < kLongest_s) {
      const bool is_settled = measurements_.size() == kMeasurements;
      if (!is_settled || ++chances_ % kOneIn == 0) Measure(scan.stamp_s - latest_.scan.stamp_s);
    }
    if (turn_rad_s < kStraight) straight_ = {latest_, {}};
  }
  latest_ = {scan, odom_T_robot, velocity};
}

void SweepDuration::Measure(double interval_s) {
  if (!straight_.grid) {
    straight_.grid.emplace(grid_options_);
    map::InsertScan(sensor::Deskew(straight_.at.scan, value_s_ * straight_.at.velocity),
                    straight_.at.odom_T_robot, {}, &*straight_.grid);
  }
  const scan_matching::ScanPoints points = scan_matching::MakeScanPoints(latest_.scan);
  SweepFit best;
  const double longest_s = std::clamp(interval_s, kUsualSweep_s, kLongestSweep_s);
  for (double sweep_s = -longest_s; sweep_s <= longest_s + 1e-9; sweep_s += kStep_s) {
    const SweepFit fit =
        FitSweep(*straight_.grid, points, latest_.velocity,
                 {.world_T_robot = latest_.odom_T_robot, .sweep_s = sweep_s}, gauss_newton_);
    if (fit.inliers > best.inliers) best = fit;
  }
  const double max_sigma_s = std::max(kMaxSigma_s, kMaxSigma * std::abs(best.sweep_s));
  if (best.inliers < kFits * static_cast<double>(points.size()) ||
      best.information * max_sigma_s * max_sigma_s < kBeamsThatCountAsOne) {
    return;
  }
  measurements_.push_back({best.sweep_s, std::min(best.information, kMostInformation)});
  if (measurements_.size() > kMeasurements) measurements_.pop_front();
  Conclude();
}

void SweepDuration::Conclude() {
  const double median_s = WeightedMedian(measurements_);
  double information = 0.0;
  for (const Measurement& measured : measurements_) information += measured.information;
  const auto agreeing =
      std::count_if(measurements_.begin(), measurements_.end(), [&](const Measurement& measured) {
        return std::abs(measured.sweep_s - median_s) < 0.5 * std::abs(median_s);
      });
  const auto part = static_cast<double>(agreeing) / static_cast<double>(measurements_.size());
  if (measurements_.size() >= kProvenBy && std::abs(median_s) > kShortest_s &&
      median_s * median_s * information > kSure * kSure * kBeamsThatCountAsOne &&
      part >= kAgreeing) {
    is_proven_ =
        std::abs(median_s - told_s_) > (told_s_ > 0.0 ? std::max(kFarOff_s, 0.5 * told_s_) : 0.0);
    value_s_ = is_proven_ ? median_s : told_s_;
  } else if (part < kDisproving) {
    is_proven_ = false;
    value_s_ = told_s_;
  }
}

}  // namespace gmapping_spa::frontend
