// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/tf_odometry.h"

#include <gtest/gtest.h>

namespace gmapping_spa::rosbag {
namespace {

bool Is(const char* parent, const char* child, TfOdometry* odometry) {
  TransformMessage transform;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  return odometry->Is(transform);
}

TEST(TfOdometry, IsTheFirstTransformOfAFrameWithOdomInItsNameAndThenThatAlone) {
  TfOdometry odometry("");
  EXPECT_FALSE(Is("base_link", "laser", &odometry));
  EXPECT_FALSE(Is("map", "odom", &odometry));
  EXPECT_EQ(odometry.name(), "");
  EXPECT_TRUE(Is("robot1/odom_combined", "base_footprint", &odometry));
  EXPECT_FALSE(Is("robot1/odom_combined", "base_link", &odometry));
  EXPECT_FALSE(Is("odom", "base_footprint", &odometry));
  EXPECT_TRUE(Is("robot1/odom_combined", "base_footprint", &odometry));
  EXPECT_EQ(odometry.name(), "robot1/odom_combined -> base_footprint");
}

TEST(TfOdometry, IsThatOfTheFrameThatIsNamedExactly) {
  TfOdometry odometry("/wheels");
  EXPECT_FALSE(Is("odom", "base_link", &odometry));
  EXPECT_FALSE(Is("wheels_2", "base_link", &odometry));
  EXPECT_TRUE(Is("wheels", "base_link", &odometry));
}

TEST(TfOdometry, IsNotAMapBelowTheOdometry) {
  TfOdometry odometry("");
  EXPECT_FALSE(Is("odom", "map", &odometry));
  EXPECT_FALSE(Is("robot1/odom", "robot1/map", &odometry));
  EXPECT_TRUE(Is("odom", "mapping_robot", &odometry));
}

}  // namespace
}  // namespace gmapping_spa::rosbag
