// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/rival_search.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>
#include <vector>

#include "tests/frontend/loop_closure/aisles.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

constexpr synthetic::Laser kAllRound{
    .beams = 361, .field_of_view_rad = 2 * std::numbers::pi, .usable_range_m = 6.0};

// Up aisle 0, down aisle 1, then up one more, each of 21 nodes.
class Rivals : public testing::Test {
 protected:
  void Drive(int last_aisle, const synthetic::Walls& walls) {
    for (const auto& [aisle, up] : {std::pair(0, true), {1, false}, {last_aisle, true}}) {
      for (const SE2& pose : synthetic::DriveAisle(aisle, up)) poses_.push_back(pose);
    }
    scans_ = synthetic::ScansAt(poses_, walls, kAllRound);
  }

  // Of a closure that has the node in the middle of the last aisle at `world_T_found`.
  bool HasRival(const SE2& world_T_found) const {
    ClosureRecord record;
    record.old_node = 21 + 10;
    record.node = 42 + 10;
    record.old_T_node = Between(poses_[record.old_node], world_T_found);
    record.score = 1.0;  // the scans are without noise
    return RivalSearch({}).HasRival(
        poses_, [this](int k) { return scans_.at(k); }, record);
  }

  SE2 Moved(double x_m) const { return SE2{x_m, 0, 0} * poses_[42 + 10]; }

  // The estimate of the last pass.
  void MoveLastPass(double x_m) {
    for (std::size_t k = 42; k < poses_.size(); ++k) poses_[k] = SE2{x_m, 0, 0} * poses_[k];
  }

  std::vector<SE2> poses_;
  std::vector<sensor::LaserScan> scans_;
};

TEST_F(Rivals, AnAisleOffIsOneOfMany) {
  Drive(2, synthetic::Racks(0, 3));
  EXPECT_TRUE(HasRival(Moved(-synthetic::kAisles_m)));
}

TEST_F(Rivals, OneAisleThatLooksAlikeIsNone) {
  Drive(2, synthetic::Racks(1, 3));  // aisle 0 is open to the left
  EXPECT_FALSE(HasRival(Moved(-synthetic::kAisles_m)));
}

TEST_F(Rivals, OfAMoveByLessThanAQuarterOfTheWayToTheNextAreNone) {
  Drive(1, synthetic::Racks(0, 3));
  MoveLastPass(0.7);
  EXPECT_FALSE(HasRival(Moved(-0.7)));
  MoveLastPass(0.3);
  EXPECT_TRUE(HasRival(Moved(-1.0)));
}

TEST_F(Rivals, AreNotLookedForWhereTheEstimateStays) {
  Drive(2, synthetic::Racks(0, 3));
  EXPECT_FALSE(HasRival(Moved(-0.4)));
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
