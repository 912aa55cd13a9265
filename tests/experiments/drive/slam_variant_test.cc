// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/slam_variant.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "backend/spa/spa_optimizer.h"
#include "experiments/simulation/scan_player.h"
#include "experiments/simulation/truth_map.h"
#include "frontend/slam_parts.h"
#include "tests/experiments/drive/driven_room.h"

namespace gmapping_spa::drive {
namespace {

VariantSetup SetupWith(int particles) {
  VariantSetup setup;
  setup.choice = {.backend = "spa", .particles = particles};
  setup.options.particles = particles;
  setup.options.linear_update_m = 0.5;
  setup.load_optimizer = [] { return std::make_shared<spa::SpaOptimizer>(); };
  return setup;
}

const VariantListener kNobody = {[] { return false; }, [](view::Snapshot) {},
                                 [](const MapScore&) {}, [](const std::string&) {}};

bool Never() { return false; }

// What a run of SLAM makes of the same scans.
backend::Trajectory StraightRun(const RecordedTour& tour, int particles) {
  const VariantSetup setup = SetupWith(particles);
  frontend::ImprovedGmapping gmapping(
      frontend::GmappingOptions(setup.options), frontend::MakeScanMatcher(setup.options),
      frontend::BindOptimizer(setup.options, setup.load_optimizer()));
  simulation::ScanPlayer player([&](const sensor::LaserScan& scan) { gmapping.AddScan(scan); });
  tour.Play(0, tour.steps(), &player);
  return gmapping.Finish().trajectory;
}

void ExpectSame(const backend::Trajectory& a, const backend::Trajectory& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].stamp_s, b[i].stamp_s);
    EXPECT_EQ(a[i].world_T_robot, b[i].world_T_robot);
  }
}

class SlamVariantTest : public testing::Test {
 protected:
  DrivenRoom room_;
  map::TrinaryMap truth_ = simulation::TruthMap(RoomScene().world, {2.0, 3.0}, 0.1);
};

TEST_F(SlamVariantTest, FollowsAndEndsAsAStraightRun) {
  SlamVariant variant(SetupWith(3), &room_.tour, &truth_, 30.0, kNobody);
  room_.Drive({1.0, 0.3}, 40);
  room_.Drive({0.5, -0.5}, 20);
  const auto result = variant.Finish(Never);
  ASSERT_NE(result, nullptr);
  ExpectSame(result->result.trajectory, StraightRun(room_.tour, 3));
  ASSERT_TRUE(result->score.ate_m.has_value());
  EXPECT_LT(*result->score.ate_m, 0.1);
  ASSERT_TRUE(result->score.iou.has_value());
  EXPECT_GT(*result->score.iou, 0.5);
}

TEST_F(SlamVariantTest, OneThatBeginsLaterEndsAsOneFromTheStart) {
  room_.Drive({1.0, 0.3}, 40);
  SlamVariant late(SetupWith(3), &room_.tour, &truth_, 30.0, kNobody);
  room_.Drive({0.5, -0.5}, 20);
  const auto result = late.Finish(Never);
  ASSERT_NE(result, nullptr);
  ExpectSame(result->result.trajectory, StraightRun(room_.tour, 3));
}

TEST_F(SlamVariantTest, GoesOnAfterAnEndAsIfThereWasNone) {
  SlamVariant variant(SetupWith(2), &room_.tour, &truth_, 30.0, kNobody);
  room_.Drive({1.0, 0.3}, 30);
  const auto first = variant.Finish(Never);
  ASSERT_NE(first, nullptr);
  ExpectSame(variant.Finish(Never)->result.trajectory, first->result.trajectory);
  room_.Drive({0.5, -0.5}, 30);
  const auto second = variant.Finish(Never);
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->result.trajectory.size(), 60u);
  ExpectSame(second->result.trajectory, StraightRun(room_.tour, 2));
}

TEST_F(SlamVariantTest, HasNoResultWithoutAScanOrWhenItHasFailed) {
  SlamVariant variant(SetupWith(2), &room_.tour, &truth_, 30.0, kNobody);
  EXPECT_EQ(variant.Finish(Never), nullptr);
  VariantSetup broken = SetupWith(2);
  broken.load_optimizer = []() -> std::shared_ptr<backend::Optimizer> {
    throw std::runtime_error("gone");
  };
  std::string state;
  VariantListener listener = kNobody;
  listener.on_state = [&](const std::string& told) { state = told; };
  room_.Drive({1.0, 0.3}, 5);
  {
    SlamVariant failing(broken, &room_.tour, &truth_, 30.0, listener);
    EXPECT_EQ(failing.Finish(Never), nullptr);
  }
  EXPECT_EQ(state, "failed: gone");
}

}  // namespace
}  // namespace gmapping_spa::drive
