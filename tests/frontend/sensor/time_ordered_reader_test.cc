// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/time_ordered_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/frontend/sensor/fake_record_reader.h"

namespace gmapping_spa::sensor::time_ordered_reader_test {
namespace {

using testing::ElementsAre;
using testing::ThrowsMessage;

struct Result {
  std::vector<ScanRecord> scans;
  std::vector<double> stamps_s;
  std::vector<std::int64_t> indices;
  LogCounts counts;
};

Result Read(std::vector<LogRecord> records, const LogOptions& options = {}) {
  TimeOrderedReader reader(std::make_unique<FakeRecordReader>(std::move(records)), "log.clf",
                           options);
  Result result;
  while (std::optional<ScanRecord> record = reader.Next()) {
    result.stamps_s.push_back(record->scan.stamp_s);
    result.indices.push_back(record->scan.index);
    result.scans.push_back(std::move(*record));
  }
  result.counts = reader.counts();
  return result;
}

TEST(TimeOrderedReader, DisorderWithinTheWindowIsMendedAndCounted) {
  const Result result = Read({ScanWithOdometry(1.0), ScanWithOdometry(2.5), ScanWithOdometry(0.5),
                              ScanWithOdometry(2.0), ScanWithOdometry(3.0)});
  EXPECT_THAT(result.stamps_s, ElementsAre(0.5, 1.0, 2.0, 2.5, 3.0));
  EXPECT_THAT(result.indices, ElementsAre(2, 0, 3, 1, 4));
  EXPECT_EQ(result.counts.at("out_of_order_scans"), 1);
  EXPECT_EQ(result.counts.at("late_scans"), 0);
  EXPECT_EQ(result.counts.at("of_the_source"), 7);
}

TEST(TimeOrderedReader, HoldsNoMoreThanTheWindow) {
  std::vector<LogRecord> records;
  records.reserve(100);
  for (int i = 0; i < 100; ++i) records.push_back(ScanWithOdometry(i));
  auto source = std::make_unique<FakeRecordReader>(std::move(records));
  const FakeRecordReader& progress = *source;
  TimeOrderedReader reader(std::move(source), "log.clf", {});
  reader.Next();
  EXPECT_EQ(progress.position(), 4u);  // stamps 0 to 3: the first that is more than 2 s younger
}

TEST(TimeOrderedReader, ClockSetBackStartsAfreshAndLosesNothing) {
  const Result result = Read({ScanWithOdometry(100), ScanWithOdometry(101), ScanWithOdometry(10),
                              ScanWithOdometry(12), ScanWithOdometry(11)});
  EXPECT_THAT(result.stamps_s, ElementsAre(100, 101, 10, 11, 12));
  EXPECT_THAT(result.indices, ElementsAre(0, 1, 2, 4, 3));
  EXPECT_EQ(result.counts.at("late_scans"), 1);
}

TEST(TimeOrderedReader, OneWrongStampInTheFutureDisturbsItsNeighborsOnly) {
  const Result result = Read({ScanWithOdometry(1), ScanWithOdometry(1e9), ScanWithOdometry(2),
                              ScanWithOdometry(4), ScanWithOdometry(3)});
  EXPECT_THAT(result.stamps_s, ElementsAre(1, 1e9, 2, 3, 4));
}

TEST(TimeOrderedReader, LateScanIsAnErrorUnderFail) {
  LogOptions options;
  options.bad_record = BadRecordPolicy::kFail;
  EXPECT_THAT(
      [&] {
        Read({ScanWithOdometry(100), ScanWithOdometry(97.5)}, options);
      },
      ThrowsMessage<std::runtime_error>(
          "log.clf:2: expected a stamp within the reorder window, found one 2.500000 s "
          "back"));
  EXPECT_NO_THROW(Read({ScanWithOdometry(100), ScanWithOdometry(98)}, options));
}

TEST(TimeOrderedReader, OwnOdometryIsKept) {
  const Result result =
      Read({OdometryRecord{1.0, {9, 9, 1}}, ScanWithOdometry(1.0, {1.0}, {1, 2, 3})});
  EXPECT_EQ(result.scans[0].scan.odom_T_robot, (backend::SE2{1, 2, 3}));
  EXPECT_EQ(result.counts.at("odometry_interpolated"), 0);
}

TEST(TimeOrderedReader, OdometryIsInterpolatedAlongTheArc) {
  constexpr double kPi = std::numbers::pi;
  // A quarter turn to the left on a circle of radius 1, around (0, 1). ODOM comes after the scan,
  // and out of order.
  const Result result = Read({ScanWithoutOdometry(10.5), OdometryRecord{11.0, {1, 1, kPi / 2}},
                              OdometryRecord{10.0, {0, 0, 0}}});
  const backend::SE2 pose = result.scans[0].scan.odom_T_robot;
  EXPECT_NEAR(pose.x, std::sin(kPi / 4), 1e-12);
  EXPECT_NEAR(pose.y, 1 - std::cos(kPi / 4), 1e-12);
  EXPECT_NEAR(pose.theta, kPi / 4, 1e-12);
  EXPECT_EQ(result.counts.at("odometry_interpolated"), 1);
}

TEST(TimeOrderedReader, OdometryIsInterpolatedTheShortWayAround) {
  const Result result = Read({OdometryRecord{0.0, {0, 0, 3.0}}, ScanWithoutOdometry(0.5),
                              OdometryRecord{1.0, {0, 0, -3.0}}});
  EXPECT_NEAR(std::abs(result.scans[0].scan.odom_T_robot.theta), std::numbers::pi, 1e-12);
}

TEST(TimeOrderedReader, OdometryAtTheEndsIsTheNearestAndCounted) {
  const Result result =
      Read({ScanWithoutOdometry(0.0), OdometryRecord{1.0, {1, 0, 0}}, ScanWithoutOdometry(1.0),
            OdometryRecord{2.0, {2, 0, 0}}, ScanWithoutOdometry(3.0)});
  EXPECT_EQ(result.scans[0].scan.odom_T_robot.x, 1.0);
  EXPECT_EQ(result.scans[1].scan.odom_T_robot.x, 1.0);
  EXPECT_EQ(result.scans[2].scan.odom_T_robot.x, 2.0);
  EXPECT_EQ(result.counts.at("odometry_extrapolated"), 2);
  EXPECT_EQ(result.counts.at("odometry_interpolated"), 1);
}

TEST(TimeOrderedReader, LongLogsAreInterpolatedThroughout) {
  std::vector<LogRecord> records;
  for (int i = 0; i <= 1000; ++i) {
    records.push_back(OdometryRecord{i * 0.5, {i * 0.5, 0, 0}});
    if (i < 1000) records.push_back(ScanWithoutOdometry(i * 0.5 + 0.125));
  }
  const Result result = Read(std::move(records));
  ASSERT_EQ(result.scans.size(), 1000u);
  for (const ScanRecord& record : result.scans) {
    ASSERT_NEAR(record.scan.odom_T_robot.x, record.scan.stamp_s, 1e-9);
  }
}

TEST(TimeOrderedReader, OdometryFromBeforeTheClockWasSetBackIsForgotten) {
  const Result result = Read({OdometryRecord{100, {100, 0, 0}}, ScanWithoutOdometry(100),
                              OdometryRecord{10, {5, 0, 0}}, ScanWithoutOdometry(12)});
  EXPECT_EQ(result.scans[0].scan.odom_T_robot.x, 100);
  EXPECT_EQ(result.scans[1].scan.odom_T_robot.x, 5);
}

TEST(TimeOrderedReader, ScansOfALogWithoutOdometryAreDeliveredAndCounted) {
  const Result result = Read({ScanWithoutOdometry(1), ScanWithoutOdometry(2)});
  EXPECT_EQ(result.scans.size(), 2u);
  EXPECT_EQ(result.scans[1].scan.odom_T_robot, backend::SE2{});
  EXPECT_FALSE(result.scans[1].scan.has_odometry);
  EXPECT_EQ(result.counts.at("scans_without_odometry"), 2);
}

TEST(TimeOrderedReader, SweepInTwoRecordsIsDeliveredOnceWithItsOdometry) {
  const backend::SE2 pose{1, 2, 3};
  for (const bool odometry_first : {false, true}) {
    std::vector<LogRecord> records = {ScanWithoutOdometry(5, {1, 2}),
                                      ScanWithOdometry(5, {1, 2}, pose)};
    if (odometry_first) std::swap(records[0], records[1]);
    records.push_back(ScanWithOdometry(6));
    const Result result = Read(std::move(records));
    EXPECT_THAT(result.stamps_s, ElementsAre(5, 6));
    EXPECT_THAT(result.indices, ElementsAre(0, 1));
    EXPECT_TRUE(result.scans[0].scan.has_odometry);
    EXPECT_EQ(result.scans[0].scan.odom_T_robot, pose);
    EXPECT_EQ(result.counts.at("repeated_scans"), 1);
  }
}

TEST(TimeOrderedReader, DifferentScansOfOneStampAreBothDelivered) {
  const Result result = Read({ScanWithOdometry(5, {1, 2}), ScanWithOdometry(5, {1, 3}),
                              ScanWithOdometry(5, {1, 2}, {1, 0, 0})});
  EXPECT_THAT(result.indices, ElementsAre(0, 1, 2));
  EXPECT_EQ(result.counts.at("repeated_scans"), 0);
}

TEST(TimeOrderedReader, StampsThatStandStillDoNotFillTheMemory) {
  std::vector<LogRecord> records;
  records.reserve(4098);
  for (int i = 0; i < 4098; ++i) records.push_back(ScanWithOdometry(0, {1.0 + i}));
  auto source = std::make_unique<FakeRecordReader>(std::move(records));
  const FakeRecordReader& progress = *source;
  TimeOrderedReader reader(std::move(source), "log.clf", {});
  EXPECT_EQ(reader.Next()->scan.index, 0);
  EXPECT_EQ(progress.position(), 4097u);
}

}  // namespace
}  // namespace gmapping_spa::sensor::time_ordered_reader_test
