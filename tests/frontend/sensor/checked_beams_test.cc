// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/checked_beams.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "frontend/sensor/record_fields.h"
#include "tests/message_of.h"

namespace gmapping_spa::sensor {
namespace {

constexpr double kRightAngle_rad = 0.5 * std::numbers::pi;

std::string ErrorOf(std::size_t num_beams, double step_rad, const LogOptions& options = {}) {
  return MessageOf<MalformedRecord>([&] {
    CheckedBeams(std::vector<double>(num_beams, 1.0), {0.0, step_rad}, options, std::nullopt);
  });
}

TEST(CheckedBeams, ScanHasABeamAtLeast) {
  EXPECT_EQ(ErrorOf(0, 0.1), "expected at least one range, found 0 of them");
  EXPECT_EQ(ErrorOf(1, 0.0), "no error") << "a single beam spans nothing";
}

TEST(CheckedBeams, SpanMoreThanNothingAndATurnAtMost) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(ErrorOf(5, sign * kRightAngle_rad), "no error") << "the first direction is the last";
    EXPECT_EQ(ErrorOf(5, sign * 1.009 * kRightAngle_rad), "no error") << "a rounded resolution";
    EXPECT_EQ(ErrorOf(5, sign * 1.011 * kRightAngle_rad).substr(0, 50),
              "expected beams within one turn, found them to span");
  }
  EXPECT_EQ(ErrorOf(2, 0.0), "expected beams within one turn, found them to span 0.000000 rad");
  EXPECT_NE(ErrorOf(2, std::numeric_limits<double>::quiet_NaN()), "no error");
  EXPECT_NE(ErrorOf(2, std::numeric_limits<double>::infinity()), "no error");
}

TEST(CheckedBeams, OptionsMendAnglesThatMakeNoSense) {
  LogOptions options;
  options.fov_rad = kRightAngle_rad;
  EXPECT_EQ(ErrorOf(3, 0.0, options), "no error");
  options.flipped = true;
  const std::vector<Beam> beams = CheckedBeams({1.0, 1.0, 1.0}, {7.0, 60.0}, options, {});
  EXPECT_DOUBLE_EQ(beams.front().angle_rad, 0.5 * kRightAngle_rad);
  EXPECT_DOUBLE_EQ(beams.back().angle_rad, -0.5 * kRightAngle_rad);
}

TEST(CheckedBeams, LimitOfTheSensorCountsWhereItIsShorterAndBeyondTheMinimum) {
  const LogOptions options{.usable_range_m = 8.0, .range_min_m = 0.5};
  const auto is_hit = [&](double range_m, std::optional<double> maximum_range_m) {
    const Beam beam = CheckedBeams({range_m}, {}, options, maximum_range_m).at(0);
    return beam.status == BeamStatus::kHit;
  };
  EXPECT_TRUE(is_hit(7.0, std::nullopt));
  EXPECT_FALSE(is_hit(8.0, std::nullopt));
  EXPECT_TRUE(is_hit(5.5, 6.0));
  EXPECT_FALSE(is_hit(6.0, 6.0));
  EXPECT_FALSE(is_hit(8.0, 80.0));
  for (const double senseless_m : {0.0, -1.0, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(is_hit(7.0, senseless_m)) << senseless_m;
  }
}

}  // namespace
}  // namespace gmapping_spa::sensor
