// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/carmen_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace gmapping_spa::sensor {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing::ThrowsMessage;

const std::string kFlaser =
    "FLASER 4 1.00 2.00 3.00 81.83 0.5 2 1.5707963267948966 0.5 2 1.5707963267948966 "
    "976052857.337530 nohost 0.000246\n";

struct Log {
  std::vector<ScanRecord> scans;
  std::vector<OdometryRecord> odometry;
  LogCounts counts;
};

Log Read(const std::string& text, const LogOptions& options = {}) {
  CarmenReader reader(std::make_unique<std::istringstream>(text), "log.clf", options);
  Log log;
  while (std::optional<LogRecord> record = reader.Next()) {
    if (const auto* scan = std::get_if<ScanRecord>(&*record)) {
      log.scans.push_back(*scan);
    } else {
      log.odometry.push_back(std::get<OdometryRecord>(*record));
    }
  }
  log.counts = reader.counts();
  return log;
}

void ExpectNear(const backend::SE2& actual, const backend::SE2& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-9);
  EXPECT_NEAR(actual.y, expected.y, 1e-9);
  EXPECT_NEAR(actual.theta, expected.theta, 1e-9);
}

TEST(CarmenReader, FlaserGivesRangesOdometryAndIpcStamp) {
  const Log log = Read(kFlaser);
  ASSERT_EQ(log.scans.size(), 1u);
  const LaserScan& scan = log.scans[0].scan;
  EXPECT_TRUE(log.scans[0].has_odometry);
  EXPECT_EQ(log.scans[0].line, 1);
  EXPECT_EQ(scan.stamp_s, 976052857.337530);
  ExpectNear(scan.odom_T_robot, {0.5, 2, std::numbers::pi / 2});
  ExpectNear(scan.robot_T_laser, {});
  ASSERT_EQ(scan.beams.size(), 4u);
  EXPECT_EQ(scan.beams[1].range_m, 2.0);
  EXPECT_EQ(scan.beams[1].status, BeamStatus::kHit);
  EXPECT_NEAR(scan.beams[1].angle_rad, -std::numbers::pi / 6, 1e-12);
  EXPECT_EQ(scan.beams[3].status, BeamStatus::kNoReturn);
}

TEST(CarmenReader, ParametersMountTheLaserFromThereOn) {
  const Log log = Read(kFlaser + "PARAM robot_frontlaser_offset 0.1 nohost 0\n" +
                       "PARAM robot_frontlaser_side_offset -0.2 nohost 0\n" +
                       "PARAM robot_frontlaser_angular_offset 0.3 nohost 0\n" + kFlaser);
  ASSERT_EQ(log.scans.size(), 2u);
  ExpectNear(log.scans[0].scan.robot_T_laser, {});
  ExpectNear(log.scans[1].scan.robot_T_laser, {0.1, -0.2, 0.3});
}

TEST(CarmenReader, FlaserTellsItsLaserPoseAndWhetherTheMountingIsKnown) {
  const std::string ahead = "FLASER 2 1 1 1.25 2 0 1 2 0 5 nohost 0\n";  // by 0.25 m
  const Log log = Read(ahead + "PARAM robot_frontlaser_offset 0.1 nohost 0\n" + ahead);
  ASSERT_EQ(log.scans.size(), 2u);
  ASSERT_TRUE(log.scans[0].told_robot_T_laser);
  ExpectNear(*log.scans[0].told_robot_T_laser, {0.25, 0, 0});
  EXPECT_FALSE(log.scans[0].mounting_is_known);
  EXPECT_TRUE(log.scans[1].mounting_is_known);
  LogOptions options;
  options.robot_T_laser = backend::SE2{};
  EXPECT_TRUE(Read(ahead, options).scans.at(0).mounting_is_known);
}

TEST(CarmenReader, AByteOrderMarkDoesNotCostTheFirstRecord) {
  const Log log = Read("\xef\xbb\xbf" + kFlaser + kFlaser);
  EXPECT_EQ(log.scans.size(), 2u);
  EXPECT_EQ(log.counts.at("unknown_records"), 0);
}

TEST(CarmenReader, AFieldOfViewThatOnlyTheTableTellsIsCounted) {
  EXPECT_EQ(Read(kFlaser + kFlaser).counts.at("assumed_field_of_view"), 2);
  LogOptions options;
  options.fov_rad = 2.0;
  EXPECT_EQ(Read(kFlaser, options).counts.at("assumed_field_of_view"), 0);
}

TEST(CarmenReader, RobotLaserBringsItsAnglesMaximumRangeAndMounting) {
  const Log log = Read(
      "ROBOTLASER1 0 -0.5 1.0 0.25 30.0 0.01 1 5 1 2 nan 30 31 5 10 20 30 40 50 "
      "1 3 1.5707963267948966 1 2 1.5707963267948966 0.3 0.1 0.4 0.2 99.0 123.5 nohost 7.5\n");
  ASSERT_EQ(log.scans.size(), 1u);
  const LaserScan& scan = log.scans[0].scan;
  EXPECT_TRUE(log.scans[0].has_odometry);
  EXPECT_EQ(scan.stamp_s, 123.5);
  ExpectNear(scan.odom_T_robot, {1, 2, std::numbers::pi / 2});
  ExpectNear(scan.robot_T_laser, {1, 0, 0});
  ASSERT_EQ(scan.beams.size(), 5u);
  EXPECT_EQ(scan.beams[0].angle_rad, -0.5);
  EXPECT_EQ(scan.beams[4].angle_rad, 0.5);
  EXPECT_EQ(scan.beams[1].status, BeamStatus::kHit);
  EXPECT_EQ(scan.beams[2].status, BeamStatus::kInvalid);
  EXPECT_EQ(scan.beams[3].status, BeamStatus::kNoReturn);
  EXPECT_EQ(scan.beams[4].range_m, 30.0);
}

TEST(CarmenReader, RawLaserHasNoOdometryAndTheMountingOfTheParameters) {
  const Log log = Read(
      "PARAM robot_frontlaser_offset 0.1 nohost 0\n"
      "RAWLASER1 0 -0.5 1.0 0.5 0 0.01 0 3 1 2 3 0 12.25 nohost 7.5\n");
  ASSERT_EQ(log.scans.size(), 1u);
  EXPECT_FALSE(log.scans[0].has_odometry);
  EXPECT_EQ(log.scans[0].scan.stamp_s, 12.25);
  ExpectNear(log.scans[0].scan.robot_T_laser, {0.1, 0, 0});
  EXPECT_EQ(log.scans[0].scan.beams[2].status, BeamStatus::kHit);  // maximum range 0: unknown
}

TEST(CarmenReader, FieldOfViewServesWhereTheResolutionIsZero) {
  const Log log = Read("RAWLASER1 0 -0.5 1.0 0 80 0.01 0 3 1 2 3 0 12.25 nohost 7.5\n");
  ASSERT_EQ(log.scans.size(), 1u);
  EXPECT_EQ(log.scans[0].scan.beams[2].angle_rad, 0.5);
}

TEST(CarmenReader, OptionsOverrideTheLog) {
  LogOptions options;
  options.robot_T_laser = backend::SE2{0.3, 0.2, 0.1};
  options.fov_rad = 3.0;
  options.flipped = true;
  const Log log = Read("PARAM robot_frontlaser_offset 0.1 nohost 0\n" + kFlaser +
                           "ROBOTLASER1 0 -0.5 1.0 0.25 30.0 0.01 0 4 1 2 3 4 0 1 3 0 1 2 0 "
                           "0 0 0 0 0 123.5 nohost 7.5\n",
                       options);
  ASSERT_EQ(log.scans.size(), 2u);
  for (const ScanRecord& record : log.scans) {
    ExpectNear(record.scan.robot_T_laser, {0.3, 0.2, 0.1});
    EXPECT_EQ(record.scan.beams[0].angle_rad, 1.5);
    EXPECT_EQ(record.scan.beams[3].angle_rad, -1.5);
  }
}

TEST(CarmenReader, OdomGivesPoseAndIpcStamp) {
  const Log log = Read("ODOM 1 2 0.5 0.1 0.2 0.3 42.5 nohost 1.5\n" + kFlaser);
  ASSERT_EQ(log.odometry.size(), 1u);
  EXPECT_EQ(log.odometry[0].stamp_s, 42.5);
  ExpectNear(log.odometry[0].odom_T_robot, {1, 2, 0.5});
}

TEST(CarmenReader, EveryRecordIsCountedAsWhatItIs) {
  const Log log = Read(
      "# comment\n\n  \t\nSYNC tag 1 nohost 1\nNMEA-GGA 1 2 3\nTRUEPOS 0 0 0 0 0 0 1 nohost 1\n" +
      kFlaser + "ODOM 1 2 0 0 0 0 42 nohost 1\nPARAM a b nohost 0\nMYLASER 1 2 3\n\x01\xff\n" +
      "FLASER 2 1\n" + kFlaser);
  EXPECT_EQ(log.counts.at("lines"), 13);
  EXPECT_EQ(log.counts.at("scan_records"), 2);
  EXPECT_EQ(log.counts.at("odometry_records"), 1);
  EXPECT_EQ(log.counts.at("ignored_records"), 4);
  EXPECT_EQ(log.counts.at("unknown_records"), 2);
  EXPECT_EQ(log.counts.at("malformed_records"), 1);
}

TEST(CarmenReader, WindowsLineEndsAndTabsAreRead) {
  const Log log = Read("FLASER\t2 1  2 0 0 0 0 0 0 7.5\r\n");
  ASSERT_EQ(log.scans.size(), 1u);  // host and logger time are not needed
  EXPECT_EQ(log.scans[0].scan.stamp_s, 7.5);
}

TEST(CarmenReader, ARangeThatIsNoFiniteNumberSpoilsItsBeamOnly) {
  const Log log = Read("FLASER 7 nan -nan inf -inf 1e400 1e300 2 0 0 0 0 0 0 7.5 h 0\n");
  ASSERT_EQ(log.scans.size(), 1u);
  const std::vector<Beam>& beams = log.scans[0].scan.beams;
  const BeamStatus expected[] = {BeamStatus::kInvalid, BeamStatus::kInvalid, BeamStatus::kNoReturn,
                                 BeamStatus::kInvalid, BeamStatus::kInvalid, BeamStatus::kNoReturn,
                                 BeamStatus::kHit};
  for (std::size_t i = 0; i < beams.size(); ++i) EXPECT_EQ(beams[i].status, expected[i]) << i;
}

class MalformedLine : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(MalformedLine, IsNamedOnceUnderSkip) {
  testing::internal::CaptureStderr();
  Read(kFlaser + GetParam().first + "\n" + GetParam().first + "\n");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("left out: log.clf:2: "));
  EXPECT_THAT(said, Not(HasSubstr("log.clf:3")));
}

TEST_P(MalformedLine, IsCountedAndLeftOutUnderSkip) {
  const Log log = Read(kFlaser + GetParam().first + "\n" + kFlaser);
  EXPECT_EQ(log.scans.size(), 2u);
  EXPECT_EQ(log.odometry.size(), 0u);
  EXPECT_EQ(log.counts.at("malformed_records"), 1);
}

TEST_P(MalformedLine, IsAnErrorOfOneLineThatNamesItsPlaceUnderFail) {
  LogOptions options;
  options.bad_record = BadRecordPolicy::kFail;
  EXPECT_THAT(
      [&] { Read(kFlaser + GetParam().first + "\n" + kFlaser, options); },
      ThrowsMessage<std::runtime_error>(AllOf(StartsWith("log.clf:2: expected "),
                                              HasSubstr(GetParam().second), Not(HasSubstr("\n")))));
}

INSTANTIATE_TEST_SUITE_P(
    CarmenReader, MalformedLine,
    testing::ValuesIn(std::vector<std::pair<std::string, std::string>>{
        {"FLASER", "number of ranges, found the end of the line"},
        {"FLASER -1 0 0 0 0 0 0 7.5 h 0", "number of ranges, found '-1'"},
        {"FLASER 1000000000 1 2 0 0 0 0 0 0 7.5 h 0", "1000000000 ranges, found a shorter line"},
        {"FLASER 18446744073709551615 1 0 0 0 0 0 0 7.5 h 0", "found a shorter line"},
        {"FLASER 99999999999999999999999 1 0 0 0 0 0 0 7.5 h 0", "number of ranges"},
        {"FLASER 2.5 1 2 0 0 0 0 0 0 7.5 h 0", "number of ranges, found '2.5'"},
        {"FLASER 0 0 0 0 0 0 0 7.5 h 0", "at least one range"},
        {"FLASER 2 1 abc 0 0 0 0 0 0 7.5 h 0", "ranges, found 'abc'"},
        {"FLASER 2 1 2x 0 0 0 0 0 0 7.5 h 0", "ranges, found '2x'"},
        {"FLASER 2 1 2 0 0 0 0 0 0", "ipc time stamp in s, found the end of the line"},
        {"FLASER 2 1 2 0 0 0 nan 0 0 7.5 h 0", "a finite robot pose, found 'nan'"},
        {"FLASER 2 1 2 0 0 0 0 inf 0 7.5 h 0", "a finite robot pose, found 'inf'"},
        {"FLASER 2 1 2 0 0 0 0 0 1e300 7.5 h 0", "robot pose of at most 1e+09, found '1e300'"},
        {"FLASER 2 1 2 0 0 0 0 0 0 nan h 0", "a finite ipc time stamp in s, found 'nan'"},
        {"FLASER 2 1 2 0 0 0 0 0 0 1e13 h 0", "ipc time stamp in s of at most 1e+12, found '1e13'"},
        {"FLASER 2 1 \x01\xff\x80 0 0 0 0 0 0 7.5 h 0", "ranges, found '\?\?\?'"},
        {"ODOM 0 0 nan 0 0 0 7.5 h 0", "a finite robot pose, found 'nan'"},
        {"ODOM 0 0 0 0 0 0", "ipc time stamp in s, found the end of the line"},
        {"PARAM robot_frontlaser_offset nan h 0", "a finite offset of the laser"},
        {"RAWLASER1 0 -0.5 1.0 nan 80 0.01 0 3 1 2 3 0 12.25 h 0", "angular resolution"},
        {"RAWLASER1 0 -90 180 90 80 0.01 0 3 1 2 3 0 12.25 h 0", "within one turn"},
        {"RAWLASER1 0 0 0 0 80 0.01 0 3 1 2 3 0 12.25 h 0", "within one turn"},
        {"RAWLASER1 0 -0.5 1.0 0.5 80 0.01 0 3 1 2 3 9 12.25 h 0", "9 remissions"},
        {"ROBOTLASER1 0 -0.5 1.0 0.5 80 0.01 0 3 1 2 3 0 0 0 0 0 0 0 0 0", "turn axis"},
        {"FLASER 2 1 " + std::string(5 << 20, '7') + " 0 0 0 0 0 0 7.5 h 0", "a line of more than"},
    }));

TEST(CarmenReader, RecordCutOffByTheEndOfTheFileIsMalformed) {
  const std::string whole = "FLASER 2 1 2 0 0 0 0 0 0 976052857.33 nohost 0.25";
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const Log log = Read(kFlaser + whole.substr(0, size));
    // Once the host has begun the stamp is complete.
    const bool complete = size > whole.find("nohost");
    EXPECT_EQ(log.scans.size(), complete ? 2u : 1u) << size;
  }
}

TEST(CarmenReader, LogWithoutScansIsAnErrorThatTellsWhatThereWas) {
  EXPECT_THAT([] { Read(""); }, ThrowsMessage<std::runtime_error>(
                                    "log.clf: no laser scans found (0 lines, 0 records unknown, 0 "
                                    "of kinds that are not read, 0 malformed)"));
  EXPECT_THAT([] { Read("ODOM 1 2 0 0 0 0 42 nohost 1\nhello\nFLASER 0\n"); },
              ThrowsMessage<std::runtime_error>(
                  "log.clf: no laser scans found (3 lines, 1 records unknown, 0 of kinds that are "
                  "not read, 1 malformed, the "
                  "first: log.clf:3: expected laser pose, found the end of the line)"));
}

}  // namespace
}  // namespace gmapping_spa::sensor
