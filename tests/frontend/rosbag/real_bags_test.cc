// SPDX-License-Identifier: BSD-3-Clause
// Bags that others wrote.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frontend/rosbag/open_source.h"
#include "tests/frontend/rosbag/small_bag.h"
#include "tests/message_of.h"
#include "tests/real_data.h"

namespace gmapping_spa::rosbag {
namespace {

using ::testing::HasSubstr;

TEST(RealBags, AcesHasTheScansOfItsCarmenLog) {
  const auto path = RealDataPath("rosbag/aces.orig.bag");
  if (!path) GTEST_SKIP() << "aces.orig.bag is not there; set GMAPPING_SPA_DATA";
  const ReadBag read = ReadAll(*path, {.bad_record = sensor::BadRecordPolicy::kFail});
  EXPECT_EQ(read.scans.size(), 7374u);
  EXPECT_EQ(read.counts.at("odometry_records"), 7375);
  EXPECT_EQ(read.counts.at("laser_pose_assumed"), 0);
  EXPECT_NEAR(read.scans[0].stamp_s, 70.2899, 1e-9);
  EXPECT_NEAR(read.scans[0].beams[0].angle_rad, -1.5708, 1e-4);
}

TEST(RealBags, Db3OfARobotIsReadWhole) {
  const auto path = RealDataPath("rosbag/real_ros2.db3");
  if (!path) GTEST_SKIP() << "real_ros2.db3 is not there; set GMAPPING_SPA_DATA";
  const ReadBag read = ReadAll(*path);
  EXPECT_EQ(read.scans.size(), 85u);
  EXPECT_EQ(read.counts.at("odometry_records"), 3900);
  EXPECT_EQ(read.counts.at("laser_pose_assumed"), 85);
  EXPECT_NEAR(read.scans[0].sweep_s, 0.1637, 1e-3);
}

struct Conformance {
  const char* folder;
  std::vector<std::int64_t> messages;  // by topic
};

class Rosbag2 : public testing::TestWithParam<Conformance> {};

TEST_P(Rosbag2, IsReadMessageByMessage) {
  const auto path = RealDataPath(std::string("rosbag/rosbag2/") + GetParam().folder);
  if (!path) GTEST_SKIP() << GetParam().folder << " is not there; set GMAPPING_SPA_DATA";
  const std::unique_ptr<MessageSource> source = OpenSource(*path);
  std::vector<std::int64_t> told, found(source->contents().topics.size(), 0);
  for (const BagTopic& topic : source->contents().topics) told.push_back(topic.messages);
  std::int64_t previous_ns = 0;
  while (const auto message = source->Next()) {
    ++found[message->topic];
    EXPECT_GE(message->time_ns, previous_ns);
    previous_ns = message->time_ns;
  }
  EXPECT_EQ(found, told);
  EXPECT_EQ(found, GetParam().messages);
  EXPECT_THAT(MessageOf([&] { ReadAll(*path); }), HasSubstr("no laser scans found"));
}

INSTANTIATE_TEST_SUITE_P(RealBags, Rosbag2,
                         testing::Values(Conformance{"sqlite3/talker", {10, 0, 10}},
                                         Conformance{"sqlite3/convert_a", {100, 50}},
                                         Conformance{"mcap/talker", {10, 0, 10}}));

}  // namespace
}  // namespace gmapping_spa::rosbag
