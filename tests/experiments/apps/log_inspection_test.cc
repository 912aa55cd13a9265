// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/log_inspection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gmapping_spa::apps {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

sensor::LaserScan ScanAt(double stamp_s, const backend::SE2& odom_T_robot, double range_m) {
  sensor::LaserScan scan;
  scan.stamp_s = stamp_s;
  scan.odom_T_robot = odom_T_robot;
  scan.robot_T_laser = {0.1, 0, 0};
  scan.beams = {{-1.0, range_m, sensor::BeamStatus::kHit},
                {0.0, range_m + 1.0, sensor::BeamStatus::kHit},
                {1.5, 40.0, sensor::BeamStatus::kNoReturn}};
  return scan;
}

TEST(LogInspection, TellsTimesBeamsRangesAndTheMounting) {
  LogInspector inspector({});
  inspector.Add(ScanAt(10.0, {}, 2.5));
  inspector.Add(ScanAt(10.2, {0.1, 0, 0}, 0.5));
  inspector.Add(ScanAt(10.6, {0.2, 0, 0}, 2.25));
  const LogSummary& summary = inspector.summary();
  EXPECT_EQ(summary.scans, 3);
  EXPECT_EQ(summary.first_stamp_s, 10.0);
  EXPECT_EQ(summary.last_stamp_s, 10.6);
  EXPECT_THAT(summary.periods_s,
              ElementsAre(testing::DoubleNear(0.2, 1e-9), testing::DoubleNear(0.4, 1e-9)));
  EXPECT_THAT(summary.scans_by_beams, ElementsAre(Pair(3, 3)));
  EXPECT_EQ(summary.first_beam_rad, -1.0);
  EXPECT_EQ(summary.last_beam_rad, 1.5);
  EXPECT_EQ(summary.robot_T_laser.x, 0.1);
  EXPECT_THAT(summary.hits_by_meter, ElementsAre(1, 1, 2, 2));
  EXPECT_EQ(summary.shortest_hit_m, 0.5);
  EXPECT_EQ(summary.longest_hit_m, 3.5);
}

TEST(LogInspection, KeepsRawStepsAndCountsFaultsByTheirName) {
  LogInspector inspector({});
  inspector.Add(ScanAt(0.0, {50, 0, 0}, 2.0));
  inspector.Add(ScanAt(0.2, {50.1, 0, -0.1}, 2.1));
  inspector.Add(ScanAt(0.4, {80.1, 0, -0.1}, 2.2));
  inspector.Add(ScanAt(0.6, {0, 0, 0}, 2.3));
  inspector.Add(ScanAt(0.8, {80.1, 0, 0}, 2.4));
  const LogSummary& summary = inspector.summary();
  ASSERT_THAT(summary.steps, SizeIs(4));
  EXPECT_NEAR(summary.steps[0].length_m, 0.1, 1e-9);
  EXPECT_NEAR(summary.steps[0].turn_rad, 0.1, 1e-9);
  EXPECT_NEAR(summary.steps[1].length_m, 30.0, 1e-9);
  EXPECT_EQ(summary.steps[1].fault, sensor::OdometryFault::kImpossible);
  ASSERT_THAT(summary.findings, SizeIs(2));
  EXPECT_EQ(summary.findings.at("odometry_impossible").count, 2);
  EXPECT_EQ(summary.findings.at("odometry_impossible").first_stamp_s, 0.4);
  EXPECT_EQ(summary.findings.at("odometry_impossible").last_stamp_s, 0.8);
  EXPECT_EQ(summary.findings.at("odometry_restart").count, 1);
}

TEST(LogInspection, WheelsAreSilentOnlyWhereScansChange) {
  LogInspector standing({}), silent({});
  for (int i = 0; i < 20; ++i) {
    standing.Add(ScanAt(0.2 * i, {1, 0, 0}, 2.0 + 0.001 * i));
    silent.Add(ScanAt(0.2 * i, {1, 0, 0}, 2.0 + 0.06 * i));
  }
  EXPECT_THAT(standing.summary().silent, IsEmpty());
  ASSERT_THAT(silent.summary().silent, SizeIs(1));
  EXPECT_NEAR(silent.summary().silent[0].begin_s, 0.4, 1e-9);
  EXPECT_NEAR(silent.summary().silent[0].end_s, 3.8, 1e-9);
  EXPECT_THAT(silent.summary().findings, IsEmpty());
}

TEST(LogInspection, ALogWithoutOdometryHasNoSteps) {
  LogInspector inspector({});
  for (int i = 0; i < 3; ++i) {
    sensor::LaserScan scan = ScanAt(i, {}, 2.0);
    scan.has_odometry = false;
    inspector.Add(scan);
  }
  EXPECT_EQ(inspector.summary().scans_with_odometry, 0);
  EXPECT_THAT(inspector.summary().steps, IsEmpty());
  EXPECT_THAT(inspector.summary().odom_T_robot, IsEmpty());
  EXPECT_EQ(inspector.summary().findings.at("odometry_missing").count, 3);
}

TEST(LogInspection, SamplesAreFewAndSpreadOverTheWholeLog) {
  LogInspector inspector({});
  for (int i = 0; i < 10000; ++i) inspector.Add(ScanAt(i, {0.01 * i, 0, 0}, 2.0 + 0.001 * i));
  const std::vector<sensor::LaserScan>& samples = inspector.summary().samples;
  EXPECT_GE(samples.size(), 32u);
  EXPECT_LE(samples.size(), 64u);
  EXPECT_EQ(samples.front().stamp_s, 0.0);
  EXPECT_GT(samples.back().stamp_s, 9500.0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].stamp_s - samples[i - 1].stamp_s, samples[1].stamp_s);
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
