// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/inspection_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/experiments/apps/picture.h"

namespace gmapping_spa::apps::inspection_picture_test {
namespace {

constexpr std::uint32_t kWhite = 0xffffff, kRed = 0xd91919, kBlue = 0x1940d9, kGreen = 0x008c8c,
                        kGrey = 0x737373;

Picture Draw(const LogSummary& summary) {
  const std::string path = testing::TempDir() + "inspection_picture_" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".png";
  WriteInspectionPicture(summary, path);
  return ReadPicture(path);
}

std::int64_t Count(const Picture& picture, std::uint32_t color) {
  return std::count(picture.pixels.begin(), picture.pixels.end(), color);
}

// A robot on a round, with one step that is too fast.
LogSummary Round() {
  LogSummary summary;
  summary.scans = 100;
  summary.last_stamp_s = 19.8;
  summary.hits_by_meter = {0, 50, 100, 20};
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.05 * i;
    summary.odom_T_robot.push_back({5 * std::cos(angle), 5 * std::sin(angle), angle});
    summary.steps.push_back({0.2 * i, 0.2, 0.25, 0.05});
  }
  sensor::LaserScan scan;
  scan.odom_T_robot = summary.odom_T_robot.front();
  for (int i = 0; i < 100; ++i) scan.beams.push_back({0.03 * i, 3.0, sensor::BeamStatus::kHit});
  summary.samples.push_back(scan);
  return summary;
}

TEST(InspectionPicture, ShowsWayScansRangesAndSteps) {
  const Picture picture = Draw(Round());
  EXPECT_EQ(picture.width, 1600);
  EXPECT_EQ(picture.height, 1200);
  EXPECT_GT(Count(picture, kBlue), 100);
  EXPECT_GT(Count(picture, kGrey), 50);
  EXPECT_GT(Count(picture, kGreen), 10000);
  EXPECT_EQ(Count(picture, kRed), 0);
}

TEST(InspectionPicture, FaultsAreRed) {
  LogSummary summary = Round();
  summary.steps[50].fault = sensor::OdometryFault::kUnchanged;
  EXPECT_EQ(Count(Draw(summary), kRed), 0);
  summary.steps[50].fault = sensor::OdometryFault::kImpossible;
  EXPECT_GT(Count(Draw(summary), kRed), 20);
}

TEST(InspectionPicture, SurvivesALogWithoutOdometryAndASingleScan) {
  LogSummary nothing;
  EXPECT_GT(Count(Draw(nothing), kWhite), 1000000);
  LogSummary single = Round();
  single.odom_T_robot.resize(1);
  single.steps.clear();
  single.samples.clear();
  EXPECT_GT(Count(Draw(single), kBlue), 0);
}

TEST(InspectionPicture, SaysWhichFileCannotBeWritten) {
  EXPECT_THROW(WriteInspectionPicture(Round(), "/nowhere/inspect.png"), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::apps::inspection_picture_test
