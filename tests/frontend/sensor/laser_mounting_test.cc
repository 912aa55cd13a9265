// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/laser_mounting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tests/frontend/sensor/fake_record_reader.h"

namespace gmapping_spa::sensor::laser_mounting_test {
namespace {

using backend::SE2;

const SE2 kMounting{0.25, 0.1, 0.2};

// A robot on a round of 5 m radius, and what its record says of the laser.
ScanRecord Told(int step, const SE2& robot_T_laser) {
  const double angle = 0.02 * step;
  ScanRecord record =
      ScanWithOdometry(step, {1.0}, {5 * std::sin(angle), 5 - 5 * std::cos(angle), angle});
  record.told_robot_T_laser = robot_T_laser;
  return record;
}

std::vector<LogRecord> Tour(int scans, const SE2& robot_T_laser) {
  std::vector<LogRecord> records;
  for (int i = 0; i < scans; ++i) records.push_back(Told(i, robot_T_laser));
  return records;
}

struct Result {
  std::vector<ScanRecord> scans;
  LogCounts counts;
};

Result Read(std::vector<LogRecord> records) {
  LaserMountingReader reader(std::make_unique<FakeRecordReader>(std::move(records)));
  Result result;
  while (const std::optional<LogRecord> record = reader.Next()) {
    if (const auto* scan = std::get_if<ScanRecord>(&*record)) result.scans.push_back(*scan);
  }
  result.counts = reader.counts();
  return result;
}

void ExpectMounted(const Result& result, const SE2& robot_T_laser) {
  for (const ScanRecord& record : result.scans) {
    EXPECT_NEAR(record.scan.robot_T_laser.x, robot_T_laser.x, 1e-3) << record.scan.stamp_s;
    EXPECT_NEAR(record.scan.robot_T_laser.y, robot_T_laser.y, 1e-3) << record.scan.stamp_s;
    EXPECT_NEAR(record.scan.robot_T_laser.theta, robot_T_laser.theta, 1e-3);
  }
}

TEST(LaserMounting, LaserPosesThatAgreeMountEveryScan) {
  for (const int scans : {1, 99, 100, 101, 300}) {
    const Result result = Read(Tour(scans, kMounting));
    ASSERT_EQ(result.scans.size(), static_cast<std::size_t>(scans));
    ExpectMounted(result, kMounting);
    EXPECT_EQ(result.counts.at("laser_pose_used"), scans);
    EXPECT_EQ(result.counts.at("laser_pose_mismatches"), 0);
  }
}

TEST(LaserMounting, RoundedPosesGiveTheirMean) {
  std::vector<LogRecord> records;
  for (int i = 0; i < 200; ++i) {
    const double rounding = i % 2 == 0 ? 0.005 : -0.005;
    records.push_back(Told(i, {0.25 + rounding, 0.1 - rounding, 0.2}));
  }
  const Result result = Read(records);
  ExpectMounted(result, kMounting);
  EXPECT_EQ(result.counts.at("laser_pose_mismatches"), 0);
}

TEST(LaserMounting, ALogWhoseLaserPosesDisagreeKeepsTheLaserAtTheRobot) {
  std::vector<LogRecord> records = Tour(50, kMounting);
  for (int i = 50; i < 60; ++i) records.push_back(Told(i, {0.25 + 0.02 * (i - 48), 0.1, 0.2}));
  const Result result = Read(records);
  ExpectMounted(result, {});
  EXPECT_EQ(result.counts.at("laser_pose_used"), 0);
  EXPECT_EQ(result.counts.at("laser_pose_mismatches"), 60);
}

// As ROBOTLASER1 records of a logger that never sets the laser pose: each would mount it elsewhere.
TEST(LaserMounting, ALaserPoseThatStaysWhileTheRobotDrivesIsNoMounting) {
  std::vector<LogRecord> records;
  for (int i = 0; i < 200; ++i) {
    ScanRecord record = Told(i, {});
    record.told_robot_T_laser = Inverse(record.scan.odom_T_robot);
    record.scan.robot_T_laser = *record.told_robot_T_laser;
    records.push_back(record);
  }
  const Result result = Read(std::move(records));
  ExpectMounted(result, {});
  EXPECT_GT(result.counts.at("laser_pose_mismatches"), 190);
  EXPECT_EQ(result.counts.at("laser_pose_used"), 0);
}

TEST(LaserMounting, PosesInTheFrameOfAMapAreNoMounting) {
  // The map's frame is shifted against that of the odometry: standing or going straight, this
  // would look like a mounting.
  std::vector<LogRecord> records;
  for (int i = 0; i < 400; ++i) {
    ScanRecord record = ScanWithOdometry(i, {1.0}, {0.02 * i, 0, i < 300 ? 0.0 : 0.01 * (i - 300)});
    record.told_robot_T_laser =
        backend::Between(record.scan.odom_T_robot, SE2{0.3, 0.2, 0} * record.scan.odom_T_robot);
    records.push_back(record);
  }
  ExpectMounted(Read(records), {});
  ExpectMounted(Read(Tour(120, {30.0, 0, 0})), {});
}

TEST(LaserMounting, LaterContradictionsAreCounted) {
  std::vector<LogRecord> records = Tour(200, kMounting);
  records.push_back(Told(200, {}));
  const Result result = Read(records);
  ExpectMounted(result, kMounting);
  EXPECT_EQ(result.counts.at("laser_pose_mismatches"), 1);
}

TEST(LaserMounting, AMountingThatIsKnownStaysAndIsCompared) {
  ScanRecord record = Told(0, kMounting);
  record.scan.robot_T_laser = {0.5, 0, 0};
  record.mounting_is_known = true;
  const Result result = Read({record, record});
  ExpectMounted(result, {0.5, 0, 0});
  EXPECT_EQ(result.counts.at("laser_pose_used"), 0);
  EXPECT_EQ(result.counts.at("laser_pose_mismatches"), 2);
}

TEST(LaserMounting, KeepsTheOrderAndHoldsNothingBackWhereThereIsNothingToCompare) {
  for (const ScanRecord& plain : {ScanWithOdometry(0), Told(0, {})}) {
    auto source = std::make_unique<FakeRecordReader>(std::vector<LogRecord>(500, plain));
    const FakeRecordReader& position = *source;
    LaserMountingReader reader(std::move(source));
    for (std::size_t i = 1; i <= 500; ++i) {
      ASSERT_TRUE(reader.Next());
      EXPECT_EQ(position.position(), i);
    }
    EXPECT_FALSE(reader.Next());
  }
  std::vector<LogRecord> mixed = {ScanWithOdometry(1), OdometryRecord{2, {}}, Told(3, kMounting),
                                  OdometryRecord{4, {}}, Told(5, kMounting)};
  LaserMountingReader reader(std::make_unique<FakeRecordReader>(mixed));
  for (int i = 1; i <= 5; ++i) {
    const std::optional<LogRecord> record = reader.Next();
    ASSERT_TRUE(record);
    const auto* scan = std::get_if<ScanRecord>(&*record);
    EXPECT_EQ(scan ? scan->scan.stamp_s : std::get<OdometryRecord>(*record).stamp_s, i);
  }
}

TEST(LaserMounting, HoldsABoundedPartBack) {
  ScanRecord still = Told(0, kMounting);
  auto source = std::make_unique<FakeRecordReader>(std::vector<LogRecord>(3000, still));
  const FakeRecordReader& position = *source;
  LaserMountingReader reader(std::move(source));
  ASSERT_TRUE(reader.Next());
  EXPECT_EQ(position.position(), 1000u);
}

}  // namespace
}  // namespace gmapping_spa::sensor::laser_mounting_test
