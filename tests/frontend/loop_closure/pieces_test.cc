// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gmapping_spa::loop_closure {
namespace {

using backend::Edge;
using backend::SE2;

constexpr int kNodes = 12;

// Three pieces of four nodes, one metre apart, each in a straight line.
class ThreePieces : public testing::Test {
 protected:
  ThreePieces() {
    pieces_.Begin(4);
    pieces_.Begin(8);
    for (int node = 0; node < kNodes; ++node) poses_.push_back({1.0 * node, 0, 0});
  }

  static Edge Closure(int i, int j, const SE2& i_T_j) {
    Edge edge;
    edge.i = i;
    edge.j = j;
    edge.i_T_j = i_T_j;
    return edge;
  }

  double Off(int i, int j, const SE2& i_T_j) const {
    const SE2 off = Between(i_T_j, Between(poses_[i], poses_[j]));
    return off.translation().norm() + std::abs(off.theta);
  }

  Pieces pieces_;
  std::vector<SE2> poses_;
};

TEST_F(ThreePieces, KnowTheirNodes) {
  EXPECT_EQ(pieces_.size(), 3);
  EXPECT_EQ(pieces_.PieceOf(0), 0);
  EXPECT_EQ(pieces_.PieceOf(3), 0);
  EXPECT_EQ(pieces_.PieceOf(4), 1);
  EXPECT_EQ(pieces_.PieceOf(11), 2);
  EXPECT_FALSE(pieces_.BeginsAt(0));
  EXPECT_FALSE(pieces_.BeginsAt(7));
  EXPECT_TRUE(pieces_.BeginsAt(8));
}

TEST_F(ThreePieces, AreJoinedByClosuresOnly) {
  EXPECT_EQ(pieces_.Joined({}), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(pieces_.Joined(std::vector<Edge>{Closure(0, 3, {})}), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(pieces_.Joined(std::vector<Edge>{Closure(5, 9, {})}), (std::vector<int>{0, 1, 1}));
}

TEST_F(ThreePieces, AreJoinedByWayOfALaterOne) {
  const std::vector<Edge> closures = {Closure(5, 9, {}), Closure(2, 10, {})};
  EXPECT_EQ(pieces_.Joined(closures), (std::vector<int>{0, 0, 0}));
}

TEST_F(ThreePieces, TheLargestIsWhatIsJoined) {
  EXPECT_EQ(pieces_.Largest(kNodes, std::vector<Edge>{Closure(5, 9, {})}),
            (std::vector<bool>{false, true, true}));
  EXPECT_EQ(pieces_.Largest(10, {}), (std::vector<bool>{true, false, false}));
  EXPECT_EQ(pieces_.JoinedWith(11, {}), (std::vector<bool>{false, false, true}));
}

TEST_F(ThreePieces, AreMovedAsAWholeToWhereClosuresPutThem) {
  const SE2 turned{3, -2, 2.5}, back{0.5, 7, -3};
  // The second piece is found by way of the third one.
  pieces_.Arrange(std::vector<Edge>{Closure(5, 9, turned), Closure(2, 10, back)}, &poses_);
  EXPECT_LT(Off(5, 9, turned), 1e-9);
  EXPECT_LT(Off(2, 10, back), 1e-9);
  for (const int first : {0, 4, 8}) EXPECT_LT(Off(first, first + 3, {3, 0, 0}), 1e-9);
  EXPECT_EQ(poses_[1].x, 1.0);
}

TEST_F(ThreePieces, StayWhereClosuresFindThemAboutRight) {
  const std::vector<SE2> before = poses_;
  pieces_.Arrange(std::vector<Edge>{Closure(1, 5, {4.3, 0.3, 0.1})}, &poses_);
  EXPECT_TRUE(poses_ == before);
}

TEST_F(ThreePieces, AreOutOfSightUntilTheyAreJoined) {
  pieces_.Separate(std::vector<Edge>{Closure(5, 9, {4, 0, 0})}, Pieces::Sight::kScans, &poses_);
  EXPECT_GT(Between(poses_[3], poses_[4]).translation().norm(), 1000.0);
  EXPECT_LT(Off(5, 9, {4, 0, 0}), 1e-9);
}

TEST(Pieces, ToWhichTheWheelsToldTheWayAreInSightOfTheWheelsOnly) {
  Pieces pieces;
  pieces.Begin(2, true);
  pieces.Begin(4, false);
  const std::vector<SE2> before = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  std::vector<SE2> by_wheels = before, by_scans = before;
  pieces.Separate({}, Pieces::Sight::kWheels, &by_wheels);
  pieces.Separate({}, Pieces::Sight::kScans, &by_scans);
  EXPECT_TRUE(by_wheels[2] == before[2]);
  EXPECT_GT(Between(by_wheels[3], by_wheels[4]).translation().norm(), 1000.0);
  EXPECT_GT(Between(by_scans[1], by_scans[2]).translation().norm(), 1000.0);
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
