// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/ros_messages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "frontend/sensor/record_fields.h"
#include "tests/frontend/rosbag/small_bag.h"

namespace gmapping_spa::rosbag {
namespace {

class BothEncodings : public testing::TestWithParam<Encoding> {};

TEST_P(BothEncodings, FirstEchoesAreTheRanges) {
  conversion::MessageBytes message(GetParam());
  message.Header(3 * kSecond_ns, "/laser");
  for (const float value : {-1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.1f, 30.0f}) message.Put(value);
  message.Put(std::uint32_t{3}).Floats({1.5f, 2.5f}).Floats({}).Floats({4.0f});
  const LaserScanMessage scan =
      ParseLaserScan(message.bytes(), GetParam(), MessageType::kMultiEchoLaserScan);
  EXPECT_EQ(scan.header.stamp_ns, 3 * kSecond_ns);
  EXPECT_EQ(scan.header.frame_id, "laser");
  ASSERT_EQ(scan.ranges_m.size(), 3u);
  EXPECT_EQ(scan.ranges_m[0], 1.5);
  EXPECT_TRUE(std::isnan(scan.ranges_m[1]));
  EXPECT_EQ(scan.ranges_m[2], 4.0);
}

TEST_P(BothEncodings, PoseOfARobotOnASlopeIsThatSeenFromAbove) {
  // Pitched by 0.3 rad, then turned by 1 rad.
  const PoseNumbers pose = {1.0,
                            2.0,
                            3.0,
                            -std::sin(0.5) * std::sin(0.15),
                            std::cos(0.5) * std::sin(0.15),
                            std::sin(0.5) * std::cos(0.15),
                            std::cos(0.5) * std::cos(0.15)};
  const std::string bytes = OdometryBytes(GetParam(), kSecond_ns, pose, "base");
  const OdometryMessage odometry = ParseOdometry(bytes, GetParam());
  EXPECT_EQ(odometry.child_frame_id, "base");
  EXPECT_EQ(odometry.odom_T_child.y, 2.0);
  EXPECT_NEAR(odometry.odom_T_child.theta, 1.0, 1e-12);
  const auto tf = ParseTf(TfBytes(GetParam(), kSecond_ns, "odom", "base", pose), GetParam());
  EXPECT_NEAR(InPlane(tf.at(0).parent_T_child).theta, 1.0, 1e-12);
}

TEST_P(BothEncodings, WhatIsNoPoseIsMalformed) {
  for (const PoseNumbers& pose : {PoseNumbers{0, 0, 0, 0, 0, 0, 0},
                                  {0, 0, 0, 0, 0, 0, 2},
                                  {NAN, 0, 0, 0, 0, 0, 1},
                                  {1e30, 0, 0, 0, 0, 0, 1}}) {
    const std::string bytes = OdometryBytes(GetParam(), kSecond_ns, pose);
    EXPECT_THROW(ParseOdometry(bytes, GetParam()), sensor::MalformedRecord);
  }
}

INSTANTIATE_TEST_SUITE_P(RosMessages, BothEncodings,
                         testing::Values(Encoding::kRos1, Encoding::kCdr));

}  // namespace
}  // namespace gmapping_spa::rosbag
