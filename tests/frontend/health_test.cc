// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/health.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace gmapping_spa::frontend {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string Logged(const Health& health) {
  testing::internal::CaptureStderr();
  health.LogSummary();
  return testing::internal::GetCapturedStderr();
}

TEST(Health, CountsFindingsAndKeepsTheFirstMessage) {
  Health health;
  health.Report("restart", 12.0, "the encoders restarted");
  health.Report("restart", 14.0, "once more");
  health.Report("silence", 13.0, "the wheels say nothing");
  ASSERT_EQ(health.findings().size(), 2u);
  const Finding& restart = health.findings().at("restart");
  EXPECT_EQ(restart.message, "the encoders restarted");
  EXPECT_EQ(restart.count, 2);
  EXPECT_EQ(restart.first_stamp_s, 12.0);
  EXPECT_EQ(restart.last_stamp_s, 14.0);
  EXPECT_EQ(health.findings().at("silence").count, 1);
}

TEST(Health, WarnsOfTheFirstOfAKindOnly) {
  Health health;
  testing::internal::CaptureStderr();
  health.Report("restart", 976052857.3375, "the encoders restarted");
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("at 976052857.337 s: the encoders restarted"));
  testing::internal::CaptureStderr();
  health.Report("restart", 976052858.0, "the encoders restarted");
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
}

TEST(Health, ScansNearOneAnotherAreOneStretch) {
  Health health;
  for (const double stamp_s : {10.0, 11.9, 13.5, 15.5, 16.0}) health.Mark("lost", stamp_s);
  const std::vector<Stretch>& lost = health.stretches().at("lost");
  ASSERT_EQ(lost.size(), 2u);
  EXPECT_EQ(lost[0].begin_s, 10.0);
  EXPECT_EQ(lost[0].end_s, 13.5);
  EXPECT_EQ(lost[0].scans, 3);
  EXPECT_EQ(lost[1].begin_s, 15.5);
  EXPECT_EQ(lost[1].end_s, 16.0);
}

TEST(Health, KindsHaveStretchesOfTheirOwnAndAClockSetBackStartsOne) {
  Health health;
  health.Mark("lost", 100.0);
  health.Mark("ambiguous", 101.0);
  health.Mark("lost", 99.5);
  health.Mark("lost", 10.0);
  EXPECT_EQ(health.stretches().at("ambiguous").size(), 1u);
  const std::vector<Stretch>& lost = health.stretches().at("lost");
  ASSERT_EQ(lost.size(), 2u);
  EXPECT_EQ(lost[0].begin_s, 99.5);
  EXPECT_EQ(lost[0].end_s, 100.0);
  EXPECT_EQ(lost[1].begin_s, 10.0);
}

TEST(Health, MergesStretchesThatWereMarkedApartAndOverlap) {
  Health health;
  for (const double stamp_s : {29.8, 31.0, 50.0, 10.0, 30.0, 30.5, 32.5}) {
    health.Mark("lost", stamp_s);
  }
  health.Mark("ambiguous", 1.0);
  health.MergeStretches("lost");
  health.MergeStretches("never marked");
  const std::vector<Stretch>& lost = health.stretches().at("lost");
  ASSERT_EQ(lost.size(), 3u);
  EXPECT_EQ(lost[0].begin_s, 10.0);
  EXPECT_EQ(lost[1].begin_s, 29.8);
  EXPECT_EQ(lost[1].end_s, 32.5);
  EXPECT_EQ(lost[1].scans, 5);
  EXPECT_EQ(lost[2].begin_s, 50.0);
  EXPECT_EQ(health.stretches().size(), 2u);
}

TEST(Health, SummaryHasALineForEachKindThatCameMoreThanOnce) {
  Health health;
  health.Report("once", 1.0, "only this time");
  for (int i = 0; i < 3; ++i) health.Report("often", 1.0 + i, "again");
  health.Mark("lost", 5.0);
  health.Mark("lost", 6.5);
  const std::string logged = Logged(health);
  EXPECT_THAT(
      logged,
      AllOf(HasSubstr("often: 3 times from 1.000 s to 3.000 s; the first: again"),
            HasSubstr("lost: 1 stretch of 2 scans and 1.500 s in all; the first from 5.000 s")));
  EXPECT_THAT(logged, Not(HasSubstr("once")));
  EXPECT_EQ(std::count(logged.begin(), logged.end(), '\n'), 2);
}

TEST(Health, NothingNoticedIsNothingSaid) { EXPECT_THAT(Logged({}), IsEmpty()); }

}  // namespace
}  // namespace gmapping_spa::frontend
