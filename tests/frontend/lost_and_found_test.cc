// SPDX-License-Identifier: BSD-3-Clause
// A robot that is carried away, or sees nonsense for a while, and what becomes of its map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "backend/counter_random.h"
#include "backend/scheduling/optimize_safely.h"
#include "backend/spa/spa_optimizer.h"
#include "frontend/improved_gmapping.h"
#include "frontend/scan_matching/gauss_newton_matcher.h"
#include "tests/frontend/loop_closure/hall.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

const synthetic::Laser kLaser{.beams = 121, .field_of_view_rad = 4.5, .usable_range_m = 12.0};

class LostAndFound : public testing::Test {
 protected:
  // Drives on the Ring's middle line in 0.2 s and 0.2 m from scan to scan. When it begins elsewhere
  // than the last drive ended, the robot was carried there: the wheels know nothing of it.
  void Drive(double from_m, double to_m, const synthetic::Walls& walls) {
    const std::vector<SE2> poses = synthetic::DriveOnRing(from_m, to_m, 0.2);
    const SE2 odom_T_world =
        (scans_.empty() ? SE2{} : scans_.back().odom_T_robot) * Inverse(poses.front());
    for (sensor::LaserScan scan : synthetic::ScansAt(poses, walls, kLaser)) {
      truth_.push_back(scan.odom_T_robot);
      scan.odom_T_robot = odom_T_world * scan.odom_T_robot;
      scan.index = static_cast<std::int64_t>(scans_.size());
      scan.stamp_s = 0.2 * static_cast<double>(scan.index);
      scans_.push_back(scan);
    }
  }

  // A crowd around the laser, another one for each scan.
  void SeeNonsense(std::size_t first, std::size_t last) {
    backend::CounterRandom random(1, 2, 3, 4);
    for (std::size_t k = first; k <= last; ++k) {
      for (sensor::Beam& beam : scans_[k].beams) {
        beam = {beam.angle_rad, 0.5 + random.Uniform(), sensor::BeamStatus::kHit};
      }
    }
  }

  // What goes along with the robot and hides all around it, the same for each scan.
  void Cover(std::size_t first, std::size_t last) {
    for (std::size_t k = first; k <= last; ++k) {
      for (sensor::Beam& beam : scans_[k].beams) beam.range_m = std::min(beam.range_m, 1.2);
    }
  }

  void Run() {
    ImprovedGmapping::Options options;
    options.filter.particles = 2;
    options.filter.edges.measurement = particle_filter::EdgeModel::Measurement::kControl;
    gmapping_ = std::make_unique<ImprovedGmapping>(
        options,
        std::make_shared<scan_matching::GaussNewtonMatcher>(
            scan_matching::GaussNewtonMatcher::Options{}, options.filter.endpoint),
        [spa = std::make_shared<spa::SpaOptimizer>()](backend::PoseGraph* graph) {
          return backend::OptimizeSafely({}, spa.get(), graph);
        });
    for (const sensor::LaserScan& scan : scans_) gmapping_->AddScan(scan);
    estimate_ = std::make_unique<SlamResult>(gmapping_->Finish());
  }

  double LargestError(std::size_t first, std::size_t last) const {
    double largest_m = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
      const SE2 off =
          Between(Between(truth_[0], truth_[k]), estimate_->trajectory.at(k).world_T_robot);
      largest_m = std::max(largest_m, off.translation().norm());
    }
    return largest_m;
  }

  // Part of the cells of the map in which beams ended far from where any did in the other one.
  static double DrawnOver(const map::OccupancyGrid& map, const map::OccupancyGrid& good) {
    const auto near_good = [&good](int x, int y) {
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
          if (good.cell({x + dx, y + dy}).hits > 0) return true;
        }
      }
      return false;
    };
    int hit = 0, drawn_over = 0;
    const map::OccupancyGrid::Extent extent = map.KnownExtent();
    for (int y = extent.min.y; y < extent.max.y; ++y) {
      for (int x = extent.min.x; x < extent.max.x; ++x) {
        if (map.cell({x, y}).hits == 0) continue;
        ++hit;
        drawn_over += near_good(x, y) ? 0 : 1;
      }
    }
    return static_cast<double>(drawn_over) / std::max(hit, 1);
  }

  std::int64_t Count(const std::string& kind) const {
    const auto found = gmapping_->health().findings().find(kind);
    return found == gmapping_->health().findings().end() ? 0 : found->second.count;
  }

  std::vector<sensor::LaserScan> scans_;
  std::vector<SE2> truth_;
  std::unique_ptr<ImprovedGmapping> gmapping_;
  std::unique_ptr<SlamResult> estimate_;
};

TEST_F(LostAndFound, ARobotThatIsCarriedToAKnownPlaceIsFoundAgain) {
  Drive(0, 46, synthetic::Hall());
  const std::size_t carried = scans_.size();
  Drive(70, 105, synthetic::Hall());
  Run();
  EXPECT_EQ(gmapping_->counts().pieces, 2);
  EXPECT_EQ(Count("new_piece"), 1);
  EXPECT_EQ(Count("piece_not_joined"), 0);
  // A map of few scans holds the first metre less well.
  EXPECT_LT(LargestError(0, carried - 1), 0.1);
  EXPECT_LT(LargestError(carried, carried + 5), 1.0);
  EXPECT_LT(LargestError(carried + 6, scans_.size() - 1), 0.1);
}

TEST_F(LostAndFound, WhereItHasNeverBeenTheLargestPieceIsTheMap) {
  Drive(0, 46, synthetic::Hall());
  const std::size_t carried = scans_.size();
  Run();
  const map::OccupancyGrid there = estimate_->map;
  Drive(70, 90, synthetic::Ring());
  Run();
  EXPECT_EQ(Count("new_piece"), 1);
  EXPECT_EQ(Count("piece_not_joined"), 1);
  EXPECT_LT(LargestError(0, carried - 1), 0.1);
  EXPECT_LT(DrawnOver(estimate_->map, there), 0.02);
}

TEST_F(LostAndFound, NonsenseForALongTimeBeginsNoPieceAndIsNotDrawn) {
  Drive(0, 12, synthetic::Hall());
  Run();
  const map::OccupancyGrid undisturbed = estimate_->map;
  SeeNonsense(20, 35);
  Run();
  EXPECT_EQ(gmapping_->counts().pieces, 1);
  EXPECT_GE(Count("unmatched_scan"), 10);
  EXPECT_TRUE(gmapping_->health().stretches().contains("lost"));
  EXPECT_LT(LargestError(0, scans_.size() - 1), 0.1);
  EXPECT_LT(DrawnOver(estimate_->map, undisturbed), 0.02);
}

TEST_F(LostAndFound, ACoverForSecondsIsNoOtherPlace) {
  Drive(0, 40, synthetic::Hall());
  Cover(100, 120);
  Run();
  EXPECT_EQ(gmapping_->counts().pieces, 1);
  EXPECT_GE(Count("unmatched_scan"), 10);
  EXPECT_LT(LargestError(0, scans_.size() - 1), 0.15);
}

TEST_F(LostAndFound, AHealthyRobotIsNeverLost) {
  Drive(0, 60, synthetic::Hall());
  Run();
  EXPECT_EQ(gmapping_->counts().pieces, 1);
  EXPECT_EQ(Count("unmatched_scan"), 0);
}

}  // namespace
}  // namespace gmapping_spa::frontend
