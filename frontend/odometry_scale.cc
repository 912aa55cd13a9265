// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/odometry_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace gmapping_spa::frontend {
namespace {

// A stretch is long enough for the noise of scan matching, and straight enough that a wrong turn
// does not change its length.
constexpr double kStretch_m = 0.4;
constexpr double kStraight_rad = 0.6;
constexpr double kTold_m = 1e-3;  // wheels that tell less are silent

constexpr std::size_t kStretches = 6;
constexpr double kGross = 1.3;  // a factor that no slip explains for long
// Scans that are matched wrongly for some meters, where wheels slip as well, can feign a smaller
// factor than this: it takes more stretches.
constexpr double kPlain = 2.0;
constexpr std::size_t kStretchesIfSmall = 18;
constexpr double kSame = 1.15;      // factors of two stretches
constexpr double kMostAgree = 0.8;  // part of the stretches that has to say the same

struct Unit {
  double meters;
  const char* name;
};
constexpr Unit kUnits[] = {{0.3048, "feet"},
                           {0.0254, "inches"},
                           {0.1, "decimeters"},
                           {0.01, "centimeters"},
                           {0.001, "millimeters"}};
constexpr double kIsUnit = 1.04;

double Ratio(double a, double b) { return std::max(a / b, b / a); }

const Unit* UnitOf(double factor) {
  const auto* unit = std::ranges::find(kUnits, factor, &Unit::meters);
  return unit == std::end(kUnits) ? nullptr : unit;
}

}  // namespace

const char* OdometryScale::unit() const {
  const Unit* unit = UnitOf(factor_);
  return unit == nullptr ? "" : unit->name;
}

bool OdometryScale::Add(const backend::SE2& told, const backend::SE2& motion) {
  told_ = told_ * told;
  motion_ = motion_ * motion;
  if (std::abs(motion_.theta) > kStraight_rad) {
    Skip();
    return false;
  }
  const double way_m = motion_.translation().norm();
  if (way_m < kStretch_m) return false;
  const double told_m = told_.translation().norm();
  Skip();
  if (told_m < kTold_m) return false;
  log_ratios_.push_back(std::log(way_m / told_m));
  return Learn();
}

void OdometryScale::Skip() { told_ = motion_ = {}; }

// What the last `count` stretches say; nothing where they disagree.
std::optional<double> OdometryScale::FactorOf(std::size_t count) const {
  if (log_ratios_.size() < count) return std::nullopt;
  std::vector<double> sorted(log_ratios_.end() - static_cast<std::ptrdiff_t>(count),
                             log_ratios_.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::ranges::nth_element(sorted, middle);
  const double factor = std::exp(*middle);
  const auto agree = std::ranges::count_if(
      sorted, [factor](double log_ratio) { return Ratio(std::exp(log_ratio), factor) < kSame; });
  if (static_cast<double>(agree) < kMostAgree * static_cast<double>(count)) return std::nullopt;
  return factor;
}

bool OdometryScale::Learn() {
  if (log_ratios_.size() > kStretchesIfSmall) log_ratios_.erase(log_ratios_.begin());
  std::optional<double> found = FactorOf(kStretches);
  if (found && Ratio(*found, factor_) < kPlain) found = FactorOf(kStretchesIfSmall);
  if (!found) return false;
  double factor = *found;
  const bool is_gross = Ratio(factor, factor_) > kGross;
  if (Ratio(factor, 1.0) < kSame) factor = 1.0;
  for (const Unit& unit : kUnits) {
    if (Ratio(factor, unit.meters) < kIsUnit) factor = unit.meters;
  }
  // At first, scans may still be matched where the odometry wants them: then it is not quite a
  // unit.
  const bool is_clearer = UnitOf(factor) && factor_ != 1.0 && !UnitOf(factor_);
  if (!is_gross && !is_clearer) return false;
  factor_ = factor;
  log_ratios_.clear();
  return true;
}

}  // namespace gmapping_spa::frontend
