// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/live_source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

namespace gmapping_spa::ros {
namespace {

using rosbag::Encoding;

TEST(LiveSource, GivesMessagesInTheOrderInWhichTheyCame) {
  LiveSource source(Encoding::kRos1, 100);
  EXPECT_TRUE(source.Give(LiveSource::kTf, "a", 1));
  EXPECT_TRUE(source.Give(LiveSource::kScan, "b", 2));
  EXPECT_EQ(source.waiting_scans(), 1);
  const auto first = source.Next();
  EXPECT_EQ(first->topic, LiveSource::kTf);
  EXPECT_EQ(first->data, "a");
  EXPECT_EQ(first->time_ns, 1);
  EXPECT_EQ(source.Next()->data, "b");
  EXPECT_EQ(source.waiting_scans(), 0);
}

TEST(LiveSource, RefusesWhatItHasNoRoomFor) {
  LiveSource source(Encoding::kRos1, 10);
  EXPECT_TRUE(source.Give(LiveSource::kScan, "1234567890", 1));
  EXPECT_FALSE(source.Give(LiveSource::kScan, "1", 2));
  EXPECT_TRUE(source.Give(LiveSource::kTf, "1234567890", 3)) << "scans leave room for transforms";
  EXPECT_FALSE(source.Give(LiveSource::kTf, "1", 4));
  source.Next();
  EXPECT_TRUE(source.Give(LiveSource::kScan, "1", 5));
}

TEST(LiveSource, GivesWhatWaitsAfterTheEndButTakesNoMore) {
  LiveSource source(Encoding::kRos1, 100);
  source.Give(LiveSource::kScan, "a", 1);
  source.Close(std::chrono::hours(1));
  EXPECT_FALSE(source.Give(LiveSource::kScan, "b", 2));
  EXPECT_TRUE(source.Next());
  EXPECT_FALSE(source.Next());
}

TEST(LiveSource, LeavesWhatWaitsWhenTheTimeIsOver) {
  LiveSource source(Encoding::kRos1, 100);
  source.Give(LiveSource::kScan, "a", 1);
  source.Close(std::chrono::seconds(-1));
  EXPECT_FALSE(source.Next());
  EXPECT_EQ(source.waiting_scans(), 1);
}

TEST(LiveSource, WaitsForAMessage) {
  LiveSource source(Encoding::kRos1, 100);
  std::thread giver([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    source.Give(LiveSource::kScan, "a", 1);
  });
  EXPECT_EQ(source.Next()->data, "a");
  giver.join();
}

}  // namespace
}  // namespace gmapping_spa::ros
