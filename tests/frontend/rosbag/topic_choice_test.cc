// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/topic_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/message_of.h"

namespace gmapping_spa::rosbag {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;

constexpr MessageType kOther = MessageType::kOther, kScan = MessageType::kLaserScan,
                      kOdometry = MessageType::kOdometry, kTf = MessageType::kTf;

BagTopic Scans(const char* name, std::int64_t messages = 9) {
  return {name, "sensor_msgs/LaserScan", Encoding::kCdr, "", messages};
}
BagTopic Odometry(const char* name) { return {name, "nav_msgs/Odometry", Encoding::kCdr, "", 9}; }
BagTopic Transforms(const char* name) {
  return {name, "tf2_msgs/TFMessage", Encoding::kCdr, "", 9};
}

TopicChoice Choice(const std::vector<BagTopic>& topics, const sensor::LogOptions& options = {}) {
  BagContents contents;
  contents.topics = topics;
  return ChooseTopics(contents, "log", options);
}

std::string ErrorOf(const std::vector<BagTopic>& topics, const sensor::LogOptions& options = {}) {
  return MessageOf([&] { Choice(topics, options); });
}

TEST(TopicChoice, TopicsWithoutMessagesDoNotCount) {
  const TopicChoice choice = Choice({Scans("/scan", 0), Scans("/front"), Scans("/rear", 0)});
  EXPECT_THAT(choice.use, ElementsAre(kOther, kScan, kOther));
  EXPECT_EQ(choice.scan_topics, 0);
  EXPECT_THAT(ErrorOf({Scans("/scan", 0)}), EndsWith("found '/scan' (sensor_msgs/LaserScan))"));
}

TEST(TopicChoice, ABagThatIsCutOffBeforeItsFirstScanIsSaidToBe) {
  BagContents contents;
  contents.cut_off_bytes = 60000;
  EXPECT_THAT(
      MessageOf([&] { ChooseTopics(contents, "log", {}); }),
      EndsWith("found no topic; the bag is cut off: its last 60000 bytes are no whole record)"));
}

TEST(TopicChoice, ScansAreEnough) {
  const TopicChoice choice = Choice({Scans("/base_scan")});
  EXPECT_THAT(choice.use, ElementsAre(kScan));
  EXPECT_FALSE(choice.has_tf);
  EXPECT_FALSE(choice.odometry_from_tf);
}

TEST(TopicChoice, OdometryIsThatOfATopicThoughThereAreTransforms) {
  const TopicChoice choice =
      Choice({Scans("/scan"), Transforms("/tf"), Transforms("/tf_static"), Odometry("/wheels")});
  EXPECT_THAT(choice.use, ElementsAre(kScan, kTf, kTf, kOdometry));
  EXPECT_TRUE(choice.has_tf);
  EXPECT_FALSE(choice.odometry_from_tf);
}

TEST(TopicChoice, OdometryComesFromTransformsWhereThereIsNoTopicOrTheirsIsNamed) {
  EXPECT_TRUE(Choice({Scans("/scan"), Transforms("/tf")}).odometry_from_tf);
  const TopicChoice choice =
      Choice({Scans("/scan"), Transforms("/tf"), Odometry("/odom")}, {.odometry_topic = "tf"});
  EXPECT_TRUE(choice.odometry_from_tf);
  EXPECT_THAT(choice.use, ElementsAre(kScan, kTf, kOther));
}

TEST(TopicChoice, OdometryThatIsNamedAndNotThereIsNotTakenFromElsewhere) {
  const sensor::LogOptions options{.odometry_topic = "/wheels"};
  EXPECT_EQ(ErrorOf({Scans("/scan"), Transforms("/tf")}, options),
            "log: expected odometry on the topic '/wheels', found none at all");
  EXPECT_EQ(ErrorOf({Scans("/scan"), Transforms("/tf"), Odometry("/odom")}, options),
            "log: expected odometry on the topic '/wheels', found them on '/odom' (9)");
}

TEST(TopicChoice, OfSeveralWithOdometryTheUsualOneIsTakenAndCountedOrNoneAtAll) {
  const TopicChoice choice = Choice({Scans("/scan"), Odometry("/visual"), Odometry("odom")});
  EXPECT_THAT(choice.use, ElementsAre(kScan, kOther, kOdometry));
  EXPECT_EQ(choice.odometry_topics, 2);
  EXPECT_EQ(ErrorOf({Scans("/scan"), Odometry("/visual"), Odometry("/wheels")}),
            "log: expected one topic of odometry, found '/visual' (9), '/wheels' (9): "
            "--odometry_topic names one");
}

TEST(TopicChoice, ScansOfOneEchoAndOfSeveralAreBothScans) {
  BagTopic echoes = Scans("/echoes");
  echoes.type = "sensor_msgs/MultiEchoLaserScan";
  EXPECT_THAT(Choice({echoes}).use, ElementsAre(MessageType::kMultiEchoLaserScan));
  EXPECT_EQ(Choice({echoes, Scans("/scan")}).scan_topics, 2);
}

TEST(TopicChoice, OnlyWhatIsReadHasToBeReadable) {
  BagTopic json = Scans("/scan"), other = Scans("/scan");
  json.encoding = Encoding::kUnknown;
  other.md5sum = "0123";
  EXPECT_THAT(Choice({json, Scans("/rear")}, {.scan_topic = "/rear"}).use,
              ElementsAre(kOther, kScan));
  EXPECT_EQ(ErrorOf({json, Scans("/rear")}),
            "log: topic '/scan': expected sensor_msgs/LaserScan as ROS serializes it, found "
            "another encoding");
  EXPECT_THAT(ErrorOf({other}), EndsWith(", found '0123'"));
}

TEST(TopicChoice, LongListsOfTopicsEnd) {
  const std::vector<BagTopic> many(20, Scans("/s"));
  EXPECT_THAT(ErrorOf(many), EndsWith("'/s' (9), ...: --scan_topic names one"));
  const std::vector<BagTopic> none(20, Odometry("/o"));
  EXPECT_THAT(ErrorOf(none), EndsWith("'/o' (nav_msgs/Odometry), ...)"));
}

}  // namespace
}  // namespace gmapping_spa::rosbag
