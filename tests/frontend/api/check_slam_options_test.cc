// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "frontend/api/slam_options.h"
#include "tests/message_of.h"

namespace gmapping_spa {
namespace {

std::string ErrorOf(const SlamOptions& options) {
  return MessageOf<std::invalid_argument>([&] { CheckSlamOptions(options); });
}

TEST(CheckSlamOptions, TakesTheNamedSettings) {
  EXPECT_EQ(ErrorOf(SlamOptions::Improved()), "no error");
  EXPECT_EQ(ErrorOf(SlamOptions::PlainGmapping()), "no error");
  EXPECT_EQ(ErrorOf(SlamOptions::Paper()), "no error");
}

TEST(CheckSlamOptions, SaysWhatWasExpectedAndFound) {
  EXPECT_EQ(ErrorOf({.particles = 0}), "particles: expected a value from 1 to 100000, found 0");
}

TEST(CheckSlamOptions, RefusesWhatIsNoNumber) {
  SlamOptions options;
  options.resolution_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ErrorOf(options), "resolution_m: expected a value from 0.005 to 10, found nan");
  options = {};
  options.sweep_duration_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ErrorOf(options), "sweep_duration_s: expected a value from -1 to 1, found nan");
}

TEST(CheckSlamOptions, RefusesASweepThatWouldHaveNoEffect) {
  SlamOptions options;
  options.odometry = SlamOptions::Odometry::kRaw;
  EXPECT_EQ(ErrorOf(options), "no error");
  options.sweep_duration_s = 0.1;
  EXPECT_THAT(ErrorOf(options), testing::HasSubstr("sweep_duration_s: expected none with raw"));
}

TEST(CheckSlamOptions, LooksAtTheBackEndToo) {
  SlamOptions options;
  options.optimizer.max_iterations = -1;
  EXPECT_EQ(ErrorOf(options), "max_iterations: expected a value from 0 to 1000000000, found -1");
}

}  // namespace
}  // namespace gmapping_spa
