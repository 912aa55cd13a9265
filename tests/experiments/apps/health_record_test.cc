// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/health_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace gmapping_spa::apps {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;

const sensor::LogCounts kGood = {{"lines", 120},         {"scans", 100},
                                 {"unknown_records", 0}, {"malformed_records", 0},
                                 {"beams_hit", 9000},    {"beams_no_return", 900},
                                 {"beams_invalid", 100}, {"ignored_records", 20},
                                 {"repeated_scans", 4},  {"odometry_interpolated", 100}};

sensor::LogCounts With(const std::string& name, std::int64_t count) {
  sensor::LogCounts counts = kGood;
  counts[name] = count;
  return counts;
}

TEST(HealthRecord, NothingNoticedIsAnEmptyObject) {
  EXPECT_EQ(HealthRecord({}, kGood), Json::object());
  EXPECT_EQ(HealthRecord({}, {}), Json::object());
}

TEST(HealthRecord, CountsThatMatterAreFindingsWithoutTimes) {
  for (const char* name : {"malformed_records", "unknown_records", "late_scans",
                           "out_of_order_scans", "duplicate_stamps", "gaps", "changed_beam_counts",
                           "assumed_field_of_view", "laser_pose_used", "laser_pose_mismatches",
                           "scans_without_odometry", "odometry_extrapolated"}) {
    const Json record = HealthRecord({}, With(name, 3));
    ASSERT_EQ(record.size(), 1u) << name;
    EXPECT_EQ(record[name]["count"], 3);
    EXPECT_NE(record[name]["message"], "");
    EXPECT_FALSE(record[name].contains("first_s"));
  }
}

TEST(HealthRecord, BeamsThatHardlyEverEndOnSomethingAskAboutUnits) {
  EXPECT_THAT(FindingsOf(With("beams_hit", 100)), IsEmpty());
  const auto findings = FindingsOf(With("beams_hit", 10));
  ASSERT_THAT(findings, ElementsAre(Key("few_hits")));
  EXPECT_EQ(findings.at("few_hits").count, 10);
  EXPECT_THAT(findings.at("few_hits").message, HasSubstr("cm or mm"));
}

TEST(HealthRecord, HoldsWhatTheRunReportedWithItsTimes) {
  frontend::Health health;
  health.Report("odometry_restart", 12.5, "the encoders restarted");
  health.Report("odometry_restart", 40.0, "the encoders restarted");
  const Json record = HealthRecord(health, With("gaps", 1));
  EXPECT_EQ(record["gaps"]["count"], 1);
  EXPECT_EQ(record["odometry_restart"], (Json{{"message", "the encoders restarted"},
                                              {"count", 2},
                                              {"first_s", 12.5},
                                              {"last_s", 40.0}}));
}

TEST(HealthRecord, StretchesStandWithTheirKindReportedOrNot) {
  frontend::Health health;
  for (const double stamp_s : {1.0, 2.0, 10.0, 11.5}) health.Mark("lost", stamp_s);
  health.Report("ambiguous", 5.0, "two ways look alike");
  health.Mark("ambiguous", 5.0);
  const Json record = HealthRecord(health, {});
  EXPECT_EQ(record["lost"]["count"], 2);
  EXPECT_EQ(record["lost"]["first_s"], 1.0);
  EXPECT_EQ(record["lost"]["last_s"], 11.5);
  EXPECT_EQ(record["lost"]["stretches"], (Json{{1.0, 2.0}, {10.0, 11.5}}));
  EXPECT_EQ(record["ambiguous"]["message"], "two ways look alike");
  EXPECT_EQ(record["ambiguous"]["stretches"], Json::array({Json::array({5.0, 5.0})}));
}

TEST(WarnOf, IsALineForEachFinding) {
  sensor::LogCounts counts = With("gaps", 2);
  counts["unknown_records"] = 7;
  testing::internal::CaptureStderr();
  WarnOf(counts);  // glog's own first words are not of interest
  testing::internal::GetCapturedStderr();
  testing::internal::CaptureStderr();
  WarnOf(counts);
  const std::string logged = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(logged.begin(), logged.end(), '\n'), 2);
  EXPECT_THAT(logged, HasSubstr("gaps: 2 times between scans"));
  EXPECT_THAT(logged, HasSubstr("unknown_records: 7 records of an unknown type"));
}

}  // namespace
}  // namespace gmapping_spa::apps
