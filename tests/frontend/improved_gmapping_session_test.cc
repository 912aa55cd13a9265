// SPDX-License-Identifier: BSD-3-Clause
// A map that is gone on with another day, and robots that are found in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "backend/scheduling/optimize_safely.h"
#include "backend/spa/spa_optimizer.h"
#include "frontend/improved_gmapping.h"
#include "frontend/scan_matching/gauss_newton_matcher.h"
#include "tests/frontend/localization/known_hall.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

class ImprovedGmappingSession : public testing::Test {
 protected:
  void SetUp() override { Make({}); }

  void Make(ImprovedGmapping::Options options) {
    options.filter.particles = 2;
    options.filter.edges.measurement = particle_filter::EdgeModel::Measurement::kControl;
    gmapping_ = std::make_unique<ImprovedGmapping>(
        options,
        std::make_shared<scan_matching::GaussNewtonMatcher>(
            scan_matching::GaussNewtonMatcher::Options{}, options.filter.endpoint),
        [spa = std::make_shared<spa::SpaOptimizer>()](backend::PoseGraph* graph) {
          return backend::OptimizeSafely({}, spa.get(), graph);
        });
  }

  // A log of its own: indices, stamps and odometry begin anew.
  void Drive(double from_m, double to_m, const synthetic::Walls& walls = synthetic::Hall()) {
    const std::vector<sensor::LaserScan> scans = synthetic::Driven(walls, from_m, to_m, 0.2);
    for (sensor::LaserScan scan : scans) {
      truth_.push_back(scan.odom_T_robot);
      scan.odom_T_robot = Between(scans.front().odom_T_robot, scan.odom_T_robot);
      gmapping_->AddScan(scan);
    }
  }

  double LargestError(const SlamResult& result, std::size_t first) const {
    double largest_m = 0.0;
    for (std::size_t k = first; k < truth_.size(); ++k) {
      const SE2 truth = Between(truth_[0], truth_[k]);
      largest_m = std::max(
          largest_m, Between(truth, result.trajectory.at(k).world_T_robot).translation().norm());
    }
    return largest_m;
  }

  std::int64_t Count(const std::string& kind) const {
    const auto found = gmapping_->health().findings().find(kind);
    return found == gmapping_->health().findings().end() ? 0 : found->second.count;
  }

  std::unique_ptr<ImprovedGmapping> gmapping_;
  std::vector<SE2> truth_;
};

TEST_F(ImprovedGmappingSession, AnotherDayAndStartMakeOneMapWithTheOldOne) {
  Drive(0, 30);
  const std::size_t old_scans = truth_.size();
  gmapping_->BeginSession(MapSession::Use::kMapOn);
  Drive(18, 47);
  const SlamResult result = gmapping_->Finish();
  ASSERT_EQ(result.trajectory.size(), truth_.size());
  EXPECT_EQ(Count("piece_not_joined"), 0);
  ASSERT_EQ(gmapping_->session()->found().size(), 1u);
  EXPECT_LT(LargestError(result, 0), 0.1);
  EXPECT_EQ(gmapping_->counts().scans, static_cast<std::int64_t>(truth_.size() - old_scans));
}

TEST_F(ImprovedGmappingSession, LocalizingLeavesTheOldMapAsItIs) {
  Drive(0, 46);
  const SlamResult old = gmapping_->Finish();
  const std::size_t old_scans = truth_.size();
  gmapping_->BeginSession(MapSession::Use::kLocalize);
  Drive(70, 85);
  const SlamResult result = gmapping_->Finish();
  EXPECT_LT(LargestError(result, old_scans), 0.1);
  for (std::size_t k = 0; k < old_scans; ++k) {
    EXPECT_EQ(result.trajectory[k].world_T_robot, old.trajectory[k].world_T_robot) << k;
  }
  for (std::size_t node = 0; node < old.graph.nodes.size(); ++node) {
    EXPECT_EQ(result.graph.nodes[node].world_T_node, old.graph.nodes[node].world_T_node) << node;
  }
  const map::OccupancyGrid::Extent extent = old.map.KnownExtent();
  ASSERT_EQ(result.map.KnownExtent().max, extent.max);
  for (int y = extent.min.y; y < extent.max.y; ++y) {
    for (int x = extent.min.x; x < extent.max.x; ++x) {
      ASSERT_EQ(result.map.cell({x, y}).visits, old.map.cell({x, y}).visits);
      ASSERT_EQ(result.map.cell({x, y}).hits, old.map.cell({x, y}).hits);
    }
  }
}

TEST_F(ImprovedGmappingSession, InAnotherBuildingTheRobotIsNotFoundAndThatIsSaid) {
  Drive(0, 20);
  const map::OccupancyGrid old = gmapping_->Finish().map;
  gmapping_->BeginSession(MapSession::Use::kMapOn);
  Drive(0, 10, synthetic::Ring());
  const SlamResult result = gmapping_->Finish();
  EXPECT_TRUE(gmapping_->session()->found().empty());
  EXPECT_EQ(Count("piece_not_joined"), 1);
  EXPECT_EQ(result.map.KnownExtent().max, old.KnownExtent().max);
  EXPECT_EQ(result.map.KnownExtent().min, old.KnownExtent().min);
}

TEST_F(ImprovedGmappingSession, ARobotThatIsCarriedAwayIsFoundAgainAtOnce) {
  Drive(0, 46);
  gmapping_->BeginSession(MapSession::Use::kLocalize);
  const std::size_t old_scans = truth_.size();
  // Carried from 10 m to 32 m, which its wheels do not know.
  const auto before = synthetic::Driven(synthetic::Hall(), 4, 10);
  const auto after = synthetic::Driven(synthetic::Hall(), 32, 38);
  std::int64_t index = 0;
  for (const auto* drive : {&before, &after}) {
    const SE2 odom_T_first =
        drive == &before ? SE2{} : Between(before.front().odom_T_robot, before.back().odom_T_robot);
    for (sensor::LaserScan scan : *drive) {
      truth_.push_back(scan.odom_T_robot);
      scan.odom_T_robot = odom_T_first * Between(drive->front().odom_T_robot, scan.odom_T_robot);
      scan.index = index;
      scan.stamp_s = 0.1 * static_cast<double>(index++);
      gmapping_->AddScan(scan);
    }
  }
  const SlamResult result = gmapping_->Finish();
  EXPECT_EQ(gmapping_->session()->found().size(), 2u);
  EXPECT_EQ(Count("new_piece"), 1);
  EXPECT_LT(LargestError(result, truth_.size() - after.size() + 8), 0.1);
  EXPECT_LT(LargestError(result, old_scans), 1.0);
}

TEST_F(ImprovedGmappingSession, APoseIsPlacedOnceItIsOneInTheOldMap) {
  Drive(0, 46);
  EXPECT_TRUE(gmapping_->IsPlaced());
  for (const auto use : {MapSession::Use::kMapOn, MapSession::Use::kLocalize}) {
    gmapping_->BeginSession(use);
    EXPECT_FALSE(gmapping_->IsPlaced());
    const std::vector<sensor::LaserScan> scans = synthetic::Driven(synthetic::Hall(), 20, 30);
    std::size_t placed = 0;
    for (sensor::LaserScan scan : scans) {
      const SE2 truth = Between(truth_.front(), scan.odom_T_robot);
      scan.odom_T_robot = Between(scans.front().odom_T_robot, scan.odom_T_robot);
      gmapping_->AddScan(scan);
      if (!gmapping_->IsPlaced()) continue;
      ++placed;
      EXPECT_LT(Between(truth, gmapping_->CurrentPose()).translation().norm(), 0.15);
    }
    EXPECT_GT(placed, scans.size() / 2);
    EXPECT_TRUE(gmapping_->IsPlaced());
  }
}

TEST_F(ImprovedGmappingSession, AThirdDayGoesOnInTheMapOfTwo) {
  Drive(0, 20);
  gmapping_->BeginSession(MapSession::Use::kMapOn);
  Drive(12, 36);
  gmapping_->BeginSession(MapSession::Use::kMapOn);
  Drive(28, 47);
  const SlamResult result = gmapping_->Finish();
  EXPECT_EQ(Count("piece_not_joined"), 0);
  EXPECT_LT(LargestError(result, 0), 0.15);
}

TEST_F(ImprovedGmappingSession, FoundAtTheLastScanItIsToldWhereWithoutFinalOptimizationToo) {
  ImprovedGmapping::Options options;
  options.make_final_optimization = false;
  Make(options);
  Drive(0, 46);
  const std::size_t old_scans = truth_.size();
  gmapping_->BeginSession(MapSession::Use::kLocalize);
  const std::vector<sensor::LaserScan> scans = synthetic::Driven(synthetic::Hall(), 20, 24);
  for (sensor::LaserScan scan : scans) {
    truth_.push_back(scan.odom_T_robot);
    scan.odom_T_robot = Between(scans.front().odom_T_robot, scan.odom_T_robot);
    gmapping_->AddScan(scan);
    if (!gmapping_->session()->searches()) break;
  }
  const SlamResult result = gmapping_->Finish();
  ASSERT_EQ(gmapping_->session()->found().size(), 1u);
  EXPECT_TRUE(result.is_placed.back());
  EXPECT_LT(LargestError(result, old_scans), 0.15);
}

TEST_F(ImprovedGmappingSession, WhatWasDrivenBeforeItWasFoundIsInTheOldMapWithAnyCorrection) {
  ImprovedGmapping::Options options;
  options.make_final_optimization = false;
  options.correction = ImprovedGmapping::Correction::kPose;
  Make(options);
  Drive(0, 46);
  const std::size_t old_scans = truth_.size();
  gmapping_->BeginSession(MapSession::Use::kLocalize);
  Drive(70, 85);
  const SlamResult result = gmapping_->Finish();
  ASSERT_EQ(gmapping_->session()->found().size(), 1u);
  EXPECT_EQ(Count("piece_not_joined"), 0);
  EXPECT_LT(LargestError(result, old_scans), 0.15);
}

}  // namespace
}  // namespace gmapping_spa::frontend
