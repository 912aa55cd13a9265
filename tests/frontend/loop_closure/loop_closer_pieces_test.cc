// SPDX-License-Identifier: BSD-3-Clause
// A robot that was carried to elsewhere: loop closing joins the new piece of the path.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "frontend/loop_closure/loop_closer.h"
#include "tests/frontend/loop_closure/hall.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

class CarriedRobot : public testing::Test {
 protected:
  // Round the Hall; then in `walls` from 70 m on, where the estimate goes on from where it was.
  // `off`: by which the wheels are wrong where they tell the way meanwhile.
  void Drive(const synthetic::Walls& walls, const std::optional<SE2>& off = {}, double to_m = 105) {
    const std::vector<SE2> there = synthetic::DriveOnRing(0, 46, 1.0);
    const std::vector<SE2> then = synthetic::DriveOnRing(70, to_m, 1.0);
    estimate_ = truth_ = there;
    scans_ = synthetic::ScansAt(there, synthetic::Hall(), {.usable_range_m = 12.0});
    const SE2 wrong = off.value_or(there.back() * Inverse(then.front()));
    for (const sensor::LaserScan& scan :
         synthetic::ScansAt(then, walls, {.usable_range_m = 12.0})) {
      scans_.push_back(scan);
    }
    for (const SE2& pose : then) {
      truth_.push_back(pose);
      estimate_.push_back(wrong * pose);
    }
    const auto scan_of_node = [this](int node) { return scans_.at(node); };
    const int first = static_cast<int>(there.size());
    for (int k = 0; k < static_cast<int>(estimate_.size()); ++k) {
      if (k == first) closer_.BeginPiece(k, off.has_value());
      closer_.Update({estimate_.begin(), estimate_.begin() + k + 1}, scan_of_node);
    }
    closer_.UpdateAll(estimate_, scan_of_node);
  }

  std::vector<SE2> truth_, estimate_;
  std::vector<sensor::LaserScan> scans_;
  LoopCloser closer_{{}};
};

TEST_F(CarriedRobot, IsFoundByTheLookOfPlaces) {
  Drive(synthetic::Hall());
  EXPECT_EQ(closer_.pieces().Joined(closer_.closures()), (std::vector<int>{0, 0}));
  for (const backend::Edge& closure : closer_.closures()) {
    const SE2 off = Between(Between(truth_.at(closure.i), truth_.at(closure.j)), closure.i_T_j);
    EXPECT_LT(off.translation().norm(), 0.05) << closure.i << ' ' << closure.j;
    EXPECT_LT(std::abs(off.theta), 0.02) << closure.i << ' ' << closure.j;
  }
}

TEST_F(CarriedRobot, IsNotFoundByTheirLookWhereOthersSearch) {
  closer_.JoinPiecesFrom(47);
  Drive(synthetic::Hall());
  EXPECT_EQ(closer_.pieces().Joined(closer_.closures()), (std::vector<int>{0, 1}));
}

// It has only been lost: the wheels are a part of the proof.
TEST_F(CarriedRobot, IsFoundSoonerWhereTheWheelsSay) {
  Drive(synthetic::Hall(), SE2{0.4, -0.2, 0.05}, 82);
  EXPECT_EQ(closer_.pieces().Joined(closer_.closures()), (std::vector<int>{0, 0}));
}

TEST_F(CarriedRobot, IsNotFoundSoSoonWithoutThem) {
  Drive(synthetic::Hall(), {}, 82);
  EXPECT_EQ(closer_.pieces().Joined(closer_.closures()), (std::vector<int>{0, 1}));
}

TEST_F(CarriedRobot, IsNotFoundWhereTheWheelsSayWhereThatIsWrong) {
  Drive(synthetic::Hall(), SE2{6.0, 3.0, 0.8});
  for (const backend::Edge& closure : closer_.closures()) {
    const SE2 off = Between(Between(truth_.at(closure.i), truth_.at(closure.j)), closure.i_T_j);
    EXPECT_LT(off.translation().norm(), 0.05) << closure.i << ' ' << closure.j;
  }
}

TEST_F(CarriedRobot, StaysLostWhereItHasNeverBeen) {
  Drive(synthetic::Corridor(0.0));
  EXPECT_EQ(closer_.pieces().Joined(closer_.closures()), (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
