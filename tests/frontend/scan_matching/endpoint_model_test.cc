// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/endpoint_model.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "backend/counter_random.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

constexpr double kOccupiedThreshold = 0.1;  // the grid's default

bool IsOccupied(const map::OccupancyGrid& grid, map::CellIndex index) {
  const map::Cell& cell = grid.cell(index);
  return cell.hits > kOccupiedThreshold * cell.visits;
}

// Squared distance, in m^2, from the end point to the nearest hit mean that explains it, taken from
// the map cell by cell.
std::optional<double> SquaredDistance(const map::OccupancyGrid& grid, const ScanPoint& point,
                                      const SE2& world_T_robot) {
  const double resolution_m = grid.resolution_m();
  const Eigen::Vector2d end = world_T_robot * Eigen::Vector2d(point.x_m, point.y_m);
  const Eigen::Vector2d back =
      SE2{0, 0, world_T_robot.theta} * Eigen::Vector2d(point.back_x, point.back_y);
  const auto step = [](double component) {
    return component > 0.5 ? 1 : component < -0.5 ? -1 : 0;
  };
  const int x = static_cast<int>(std::floor(end.x() / resolution_m));
  const int y = static_cast<int>(std::floor(end.y() / resolution_m));
  std::optional<double> nearest;
  for (int at_x = x - 1; at_x <= x + 1; ++at_x) {
    for (int at_y = y - 1; at_y <= y + 1; ++at_y) {
      if (!IsOccupied(grid, {at_x, at_y})) continue;
      if (IsOccupied(grid, {at_x + step(back.x()), at_y + step(back.y())})) continue;
      const map::Cell& cell = grid.cell({at_x, at_y});
      const Eigen::Vector2d mean((at_x + cell.mean_x / 65536.0) * resolution_m,
                                 (at_y + cell.mean_y / 65536.0) * resolution_m);
      const double squared = (end - mean).squaredNorm();
      if (!nearest || squared < *nearest) nearest = squared;
    }
  }
  return nearest;
}

class RandomPoses : public testing::Test {
 protected:
  // A pose up to `spread` away from where the scan was taken.
  SE2 Pose(double spread) {
    const auto offset = [&] { return spread * (2.0 * random_.Uniform() - 1.0); };
    return {scan_pose_.x + offset(), scan_pose_.y + offset(), scan_pose_.theta + offset()};
  }

  const map::OccupancyGrid grid_ = synthetic::RoomMap();
  const SE2 scan_pose_{0.4, -0.3, 0.8};
  const ScanPoints points_ = MakeScanPoints(synthetic::Scan(synthetic::Room(), scan_pose_));
  const EndpointModel::Options options_{.score_sigma_m = 0.04,
                                        .likelihood_sigma_m = 0.06,
                                        .unmatched_sigmas = 2.0,
                                        .likelihood_gain = 0.25};
  EndpointModel model_{options_, &grid_, &points_};
  backend::CounterRandom random_{7, 0};
};

TEST_F(RandomPoses, ScoreIsThatOfTheMapItself) {
  double best = 0.0;
  for (int trial = 0; trial < 400; ++trial) {
    const SE2 pose = Pose(trial % 2 == 0 ? 0.1 : 1.0);
    double expected = 0.0;
    for (const ScanPoint& point : points_) {
      const std::optional<double> squared = SquaredDistance(grid_, point, pose);
      if (squared) expected += std::exp(-0.5 * *squared / (0.04 * 0.04));
    }
    expected /= static_cast<double>(points_.size());
    ASSERT_NEAR(model_.Score(pose), expected, 1e-5);
    best = std::max(best, expected);
  }
  EXPECT_GT(best, 0.5);
}

// Whether no beam has been where this one ends, nor ended on its last dozen cells.
bool EndsInUnseenSpace(const map::OccupancyGrid& grid, const ScanPoint& point,
                       const SE2& world_T_robot) {
  const double resolution_m = grid.resolution_m();
  const Eigen::Vector2d end = world_T_robot * Eigen::Vector2d(point.x_m, point.y_m) / resolution_m;
  const Eigen::Vector2d back =
      SE2{0, 0, world_T_robot.theta} * Eigen::Vector2d(point.back_x, point.back_y);
  const auto cell = [&](int k) -> map::CellIndex {
    const Eigen::Vector2d at = end + k * back;
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  };
  if (grid.cell(cell(0)).visits > 0) return false;
  for (int k = 1; k <= 12; ++k) {
    if (IsOccupied(grid, cell(k))) return false;
  }
  return true;
}

TEST_F(RandomPoses, EvidenceIsThatOfTheMapItself) {
  double unknown = 0.0, contradicted = 0.0;
  for (int trial = 0; trial < 400; ++trial) {
    const SE2 pose = Pose(trial % 2 == 0 ? 0.1 : 1.5);
    Evidence expected;
    for (const ScanPoint& point : points_) {
      if (const std::optional<double> squared = SquaredDistance(grid_, point, pose)) {
        expected.at_surface += point.weight;
        expected.explained += point.weight * std::exp(-0.5 * *squared / (0.04 * 0.04));
      } else {
        (EndsInUnseenSpace(grid_, point, pose) ? expected.unknown : expected.contradicted) +=
            point.weight;
      }
    }
    const Evidence found = model_.Evaluate(pose);
    ASSERT_NEAR(found.at_surface, expected.at_surface, 1e-9);
    ASSERT_NEAR(found.unknown, expected.unknown, 1e-9);
    ASSERT_NEAR(found.contradicted, expected.contradicted, 1e-9);
    ASSERT_NEAR(found.explained, expected.explained, 1e-3);
    unknown += found.unknown;
    contradicted += found.contradicted;
  }
  EXPECT_GT(unknown, 1000.0);
  EXPECT_GT(contradicted, 1000.0);
}

// Squared Mahalanobis distance from the end point to the hit means around it, taken from the map
// cell by cell; nothing where there are none.
std::optional<double> SurfaceDistance(const map::OccupancyGrid& grid, const ScanPoint& point,
                                      const SE2& world_T_robot, double sigma_m) {
  const double resolution_m = grid.resolution_m();
  const Eigen::Vector2d end = world_T_robot * Eigen::Vector2d(point.x_m, point.y_m) / resolution_m;
  const int x = static_cast<int>(std::floor(end.x())), y = static_cast<int>(std::floor(end.y()));
  double sum = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (int at_x = x - 1; at_x <= x + 1; ++at_x) {
    for (int at_y = y - 1; at_y <= y + 1; ++at_y) {
      if (!IsOccupied(grid, {at_x, at_y})) continue;
      const map::Cell& cell = grid.cell({at_x, at_y});
      const Eigen::Vector2d hit(at_x + cell.mean_x / 65536.0, at_y + cell.mean_y / 65536.0);
      const double weight = std::pow(std::max(0.0, 1.0 - (hit - end).squaredNorm() / 4.0), 2);
      sum += weight;
      mean += weight * (hit - end);
      second += weight * (hit - end) * (hit - end).transpose();
    }
  }
  if (sum == 0.0) return std::nullopt;
  mean /= sum;
  const double noise = sigma_m / resolution_m;
  const Eigen::Matrix2d covariance =
      second / sum - mean * mean.transpose() + noise * noise * Eigen::Matrix2d::Identity();
  return mean.dot(covariance.inverse() * mean);
}

TEST_F(RandomPoses, LogLikelihoodIsThatOfTheMapItselfFromNinetyBeamsAtMost) {
  const std::size_t stride = (points_.size() + 89) / 90, beams = (points_.size() - 1) / stride + 1;
  ASSERT_GT(stride, 1u);
  const double gain = 0.25 * static_cast<double>(points_.size()) / static_cast<double>(beams);
  for (int trial = 0; trial < 400; ++trial) {
    const SE2 pose = Pose(trial % 2 == 0 ? 0.1 : 1.0);
    double expected = 0.0;
    for (std::size_t k = 0; k < points_.size(); k += stride) {
      // As far off as can be expected where nothing is known, the outlier's distance at the most.
      const double otherwise = EndsInUnseenSpace(grid_, points_[k], pose) ? 1.0 : 4.0;
      const double squared = SurfaceDistance(grid_, points_[k], pose, 0.06).value_or(otherwise);
      expected -= 0.5 * gain * std::min(squared, 4.0);
    }
    ASSERT_NEAR(model_.LogLikelihood(pose), expected, 1e-3);
  }
}

TEST_F(RandomPoses, GivingUpHalfWayNeverChangesTheComparison) {
  int given_up = 0, kept = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const SE2 pose = Pose(trial % 2 == 0 ? 0.05 : 0.3);
    const double score = model_.Score(pose);
    const double at_least = trial % 5 == 0 ? score : random_.Uniform();
    const double with_limit = model_.Score(pose, at_least);
    if (score >= at_least) {
      ASSERT_EQ(with_limit, score);
      ++kept;
    } else {
      ASSERT_LT(with_limit, at_least);
      given_up += with_limit != score;
    }
  }
  EXPECT_GT(kept, 200);
  EXPECT_GT(given_up, 200);
}

TEST_F(RandomPoses, ScoreIsNearlyOneAtTheTruthAndLessAside) {
  const double truth = model_.Score(scan_pose_);
  EXPECT_GT(truth, 0.8);
  EXPECT_LT(model_.Score(scan_pose_ * SE2{0.1, 0, 0}), truth - 0.1);
  EXPECT_LT(model_.Score(scan_pose_ * SE2{0, 0, 0.05}), truth - 0.1);
}

TEST(EndpointModel, ScanWithoutPointsScoresNothing) {
  const map::OccupancyGrid grid = synthetic::RoomMap();
  const ScanPoints none;
  EndpointModel model({}, &grid, &none);
  EXPECT_EQ(model.Score({}), 0.0);
  EXPECT_EQ(model.LogLikelihood({}), 0.0);
  EXPECT_EQ(model.Evaluate({}).known(), 0.0);
}

TEST(EndpointModel, AnEmptyMapSaysNothingAgainstAnyBeam) {
  const map::OccupancyGrid grid({});
  const ScanPoints points(10, {1.0, 0.0, -1.0, 0.0});
  EndpointModel model({.unmatched_sigmas = 2.0, .likelihood_gain = 0.5}, &grid, &points);
  EXPECT_EQ(model.Score({}), 0.0);
  EXPECT_NEAR(model.LogLikelihood({}), -10 * 0.5 * 0.5 * 1.0, 1e-9);
  const Evidence evidence = model.Evaluate({});
  EXPECT_EQ(evidence.unknown, 10.0);
  EXPECT_EQ(evidence.known(), 0.0);
  EXPECT_EQ(evidence.Fit(), 1.0);
}

TEST(EndpointModel, WallIsSeenFromItsOwnSide) {
  // A wall two cells thick; the laser is to its left, so only the left cell explains a beam.
  map::OccupancyGrid grid({.resolution_m = 0.1});
  grid.AddHit(10.5, 0.5);
  grid.AddHit(11.5, 0.5);
  const ScanPoints points = {{1.15, 0.05, -1.0, 0.0}};
  EndpointModel model({.score_sigma_m = 0.1}, &grid, &points);
  EXPECT_NEAR(model.Score({}), std::exp(-0.5), 1e-4);
  // Without that rule the right one, which is nearer, does.
  EndpointModel open({.score_sigma_m = 0.1, .free_cell_in_front = false}, &grid, &points);
  EXPECT_NEAR(open.Score({}), 1.0, 1e-4);
}

TEST(EndpointModel, LikelihoodOfTheNearestHitIsThatOfTheOriginalGMapping) {
  map::OccupancyGrid grid({});  // cells of 0.05 m
  grid.AddHit(20.5, 0.5);
  grid.AddHit(21.5, 0.5);
  // On the second hit mean, 0.03 m beside the first and a metre from either.
  const ScanPoints points = {
      {1.075, 0.025, -1.0, 0.0}, {1.025, 0.055, -1.0, 0.0}, {2.025, 0.025, -1.0, 0.0}};
  EndpointModel::Options options{.likelihood_sigma_m = std::sqrt(0.075 / 2.0),
                                 .unmatched_sigmas = std::sqrt(1.0 / 0.075),
                                 .likelihood_gain = 1.0,
                                 .unseen_is_miss = true,
                                 .likelihood = EndpointModel::Likelihood::kNearestHit,
                                 .free_cell_in_front = false};
  EndpointModel model(options, &grid, &points);
  EXPECT_NEAR(model.LogLikelihood({}), -(0.03 * 0.03 + 0.5) / 0.075, 1e-4);
  // With the rule the second cell, behind the first, explains nothing; the first is a cell away.
  options.free_cell_in_front = true;
  EndpointModel strict(options, &grid, &points);
  EXPECT_NEAR(strict.LogLikelihood({}), -(0.05 * 0.05 + 0.03 * 0.03 + 0.5) / 0.075, 1e-4);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
