// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/transform_tree.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gmapping_spa::rosbag {
namespace {

Eigen::Isometry3d Shift(double x) { return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0)); }

class TransformTreeTest : public testing::Test {
 protected:
  double ShiftBetween(const std::string& target, const std::string& source) const {
    return tree_.Lookup(target, source)->translation().x();
  }
  TransformTree tree_;
};

TEST_F(TransformTreeTest, LeadsUpDownAndAcross) {
  tree_.Set("base", "laser", Shift(0.25));
  tree_.Set("base", "camera", Shift(-1.0));
  tree_.Set("odom", "base", Shift(8.0));
  EXPECT_EQ(ShiftBetween("base", "laser"), 0.25);
  EXPECT_EQ(ShiftBetween("laser", "odom"), -8.25);
  EXPECT_EQ(ShiftBetween("camera", "laser"), 1.25);
  EXPECT_EQ(ShiftBetween("base", "base"), 0.0);
  EXPECT_FALSE(tree_.Lookup("base", "map"));
}

TEST_F(TransformTreeTest, KnowsTheLatestTransform) {
  tree_.Set("base", "laser", Shift(0.25));
  tree_.Set("base", "laser", Shift(0.5));
  EXPECT_EQ(ShiftBetween("base", "laser"), 0.5);
}

TEST_F(TransformTreeTest, LoopsAreNoTree) {
  tree_.Set("a", "b", Shift(1.0));
  tree_.Set("b", "a", Shift(1.0));
  EXPECT_THROW(tree_.Lookup("a", "c"), std::runtime_error);
  tree_.Set("c", "c", Shift(1.0));
  EXPECT_THROW(tree_.Lookup("c", "d"), std::runtime_error);
}

TEST_F(TransformTreeTest, HasABoundedNumberOfLevels) {
  for (int i = 0; i < 100; ++i) tree_.Set(std::to_string(i), std::to_string(i + 1), Shift(1.0));
  EXPECT_EQ(ShiftBetween("0", "100"), 100.0);
  tree_.Set("100", "101", Shift(1.0));
  EXPECT_THROW(tree_.Lookup("0", "101"), std::runtime_error);
}

TEST_F(TransformTreeTest, HasABoundedNumberOfFrames) {
  for (int i = 0; i < 10000; ++i) tree_.Set("base", std::to_string(i), Shift(0.0));
  tree_.Set("base", "5", Shift(1.0));
  EXPECT_THROW(tree_.Set("base", "more", Shift(0.0)), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::rosbag
