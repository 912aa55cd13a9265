// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/scan_counts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gmapping_spa::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

constexpr std::int64_t ScanCounts::*kLosses[] = {&ScanCounts::lost, &ScanCounts::refused,
                                                 &ScanCounts::after_time_jump,
                                                 &ScanCounts::transforms_refused};

// Of a node that works as it should: throttled scans are what the user wants, a few wait.
ScanCounts Healthy() {
  ScanCounts counts;
  counts.received = 100;
  counts.throttled = 40;
  counts.waiting = 50;
  counts.used = 10;
  counts.silent_s = 10.0;
  return counts;
}

TEST(ScanCounts, ThrottledAndWaitingScansAreNoLoss) {
  EXPECT_TRUE(IsComplete(Healthy()));
  EXPECT_EQ(ProblemOf(Healthy()), "");
}

TEST(ScanCounts, EveryKindOfLossIsAProblem) {
  for (const auto loss : kLosses) {
    ScanCounts counts = Healthy();
    counts.*loss = 1;
    EXPECT_FALSE(IsComplete(counts));
    EXPECT_EQ(ProblemOf(counts), "scans were left out");
  }
}

TEST(ScanCounts, SilenceIsTheFirstProblemAndSaysWhetherThereWereScans) {
  ScanCounts counts = Healthy();
  counts.silent_s = 10.1;
  counts.lost = 1;
  EXPECT_EQ(ProblemOf(counts), "no scans come any more");
  counts.received = 0;
  EXPECT_EQ(ProblemOf(counts), "no scan has come yet");
}

TEST(ScanCounts, ManyThatWaitAreAProblemThoughNoneIsLost) {
  ScanCounts counts = Healthy();
  counts.waiting = 51;
  EXPECT_EQ(ProblemOf(counts).substr(0, 17), "the SLAM is behin");
  EXPECT_TRUE(IsComplete(counts));
}

TEST(ScanCounts, EveryCountHasItsName) {
  const ScanCounts counts{1, 2, 3, 4, 5, 6, 7, 8, 9.0};
  EXPECT_THAT(NamedCounts(counts),
              ElementsAre(Pair("lost", 1), Pair("received", 2), Pair("throttled", 3),
                          Pair("refused", 4), Pair("after_time_jump", 5), Pair("waiting", 6),
                          Pair("used", 7), Pair("transforms_refused", 8)));
}

}  // namespace
}  // namespace gmapping_spa::ros
