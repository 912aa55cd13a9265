// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/correlative_matching.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <vector>

#include "backend/counter_random.h"
#include "frontend/scan_matching/scan_points.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;
using Points = std::vector<Eigen::Vector2d>;

constexpr double kDeg = std::numbers::pi / 180.0;

// What a laser sees of `walls`, in the frame of the robot.
Points PointsSeen(const synthetic::Walls& walls, const SE2& world_T_robot,
                  const synthetic::Laser& laser = {}) {
  Points points;
  for (const ScanPoint& p : MakeScanPoints(synthetic::Scan(walls, world_T_robot, laser))) {
    points.push_back({p.x_m, p.y_m});
  }
  return points;
}

Points Moved(const SE2& a_T_b, const Points& b_points) {
  Points a_points;
  for (const Eigen::Vector2d& point : b_points) a_points.push_back(a_T_b * point);
  return a_points;
}

// The definition of CorrelativeMatch, pose by pose.
CorrelativeMatch BruteForce(const CorrelativeMatcher::Options& options, const Points& reference,
                            double step_rad, const Points& points, const SE2& initial,
                            int linear_steps, int angular_steps) {
  struct Scored {
    int sum, angle, x, y;
    auto Order() const { return std::tuple(-sum, angle * angle + x * x + y * y, angle, y, x); }
  };
  const ByteGrid field = MakeLikelihoodField(options.field, reference);
  const double step_m = options.field.resolution_m;
  std::vector<Scored> all;
  for (int angle = -angular_steps; angle <= angular_steps; ++angle) {
    const SE2 rotated{initial.x, initial.y, initial.theta + angle * step_rad};
    for (int y = -linear_steps; y <= linear_steps; ++y) {
      for (int x = -linear_steps; x <= linear_steps; ++x) {
        int sum = 0;
        for (const Eigen::Vector2d& point : points) {
          const Eigen::Vector2d cells = rotated * point / step_m;
          sum += field.value({map::FloorToCell(cells.x()) + x, map::FloorToCell(cells.y()) + y});
        }
        all.push_back({sum, angle, x, y});
      }
    }
  }
  const Scored best = *std::min_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.Order() < b.Order(); });
  const double full = 255.0 * static_cast<double>(points.size());
  CorrelativeMatch match;
  match.score = best.sum / full;
  match.found = match.score >= options.min_score;
  match.map_T_scan = {initial.x + best.x * step_m, initial.y + best.y * step_m,
                      initial.theta + best.angle * step_rad};
  match.runner_up_score = options.runner_up_floor * match.score;
  match.runner_up_map_T_scan = match.map_T_scan;
  const Scored* second = nullptr;
  double weights = 0.0;
  for (const Scored& pose : all) {
    const double score = pose.sum / full;
    const Eigen::Vector3d offset((pose.x - best.x) * step_m, (pose.y - best.y) * step_m,
                                 (pose.angle - best.angle) * step_rad);
    if (offset.head<2>().norm() > options.peak_separation_m + 1e-9 ||
        std::abs(offset.z()) > options.peak_separation_rad) {
      if (score >= options.runner_up_floor * match.score &&
          (!second || pose.Order() < second->Order())) {
        second = &pose;
      }
      continue;
    }
    const double weight = std::exp(options.independent_points * (score - match.score));
    if (weight < 0.01) continue;
    weights += weight;
    match.covariance += weight * offset * offset.transpose();
  }
  if (second) {
    match.runner_up_score = second->sum / full;
    match.runner_up_map_T_scan = {initial.x + second->x * step_m, initial.y + second->y * step_m,
                                  initial.theta + second->angle * step_rad};
  }
  match.covariance /= weights;
  match.covariance.diagonal() +=
      Eigen::Vector3d(step_m * step_m, step_m * step_m, step_rad * step_rad) / 12.0;
  return match;
}

// Random points and a scan that sees part of them, roughly; some of it lies outside.
class CorrelativeMatcherOnRandomPoints : public testing::TestWithParam<int> {};

TEST_P(CorrelativeMatcherOnRandomPoints, FindsWhatTryingAllPosesFinds) {
  backend::CounterRandom random(4, static_cast<std::uint32_t>(GetParam()));
  const auto within = [&](double limit) { return limit * (2.0 * random.Uniform() - 1.0); };
  const SE2 truth{within(0.5), within(0.5), within(3.0)};
  Points reference, points;
  for (int i = 0; i < 25; ++i) reference.push_back({within(2.0), within(1.5)});
  CorrelativeMatcher::Options options;
  options.field.sigma_m = 0.02 + 0.1 * random.Uniform();
  options.pyramid_levels = 1 + GetParam() % 6;
  options.min_score = 0.02;
  options.runner_up_floor = 0.1 + 0.6 * random.Uniform();
  options.peak_separation_m = 0.1 + 0.4 * random.Uniform();
  options.peak_separation_rad = 0.03 + 0.2 * random.Uniform();
  // Half of the scans fit so well that the search finds their pose before it looks elsewhere.
  const bool fits = GetParam() / 6 % 2 == 0;
  for (int i = 0; i < 20; ++i) {
    const double limit_m = fits ? 0.0 : 2.0 * options.field.sigma_m;
    const Eigen::Vector2d noise(within(limit_m), within(limit_m));
    points.push_back(Inverse(truth) * (reference[static_cast<std::size_t>(i)] + noise));
  }
  const CorrelativeMatcher matcher(options, reference);
  const double step_rad = matcher.AngularStep(points);
  const int linear_steps = static_cast<int>(26 * random.Uniform());
  const int angular_steps = static_cast<int>(13 * random.Uniform());
  const SE2 initial{truth.x + within(0.5), truth.y + within(0.5), truth.theta + within(0.1)};
  const CorrelativeMatch expected =
      BruteForce(options, reference, step_rad, points, initial, linear_steps, angular_steps);
  const CorrelativeMatch match =
      matcher.Match(points, initial,
                    {(linear_steps - 0.5) * (linear_steps > 0) * options.field.resolution_m,
                     (angular_steps - 0.5) * (angular_steps > 0) * step_rad});
  ASSERT_EQ(match.found, expected.found);
  ASSERT_TRUE(match.found);
  EXPECT_DOUBLE_EQ(match.score, expected.score);
  const SE2 difference = Between(expected.map_T_scan, match.map_T_scan);
  EXPECT_NEAR(difference.translation().norm(), 0.0, 1e-9);
  EXPECT_NEAR(difference.theta, 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(match.runner_up_score, expected.runner_up_score);
  const SE2 second_off = Between(expected.runner_up_map_T_scan, match.runner_up_map_T_scan);
  EXPECT_NEAR(second_off.translation().norm(), 0.0, 1e-9);
  EXPECT_NEAR(second_off.theta, 0.0, 1e-9);
  EXPECT_TRUE(match.covariance.isApprox(expected.covariance, 1e-9)) << match.covariance << "\n\n"
                                                                    << expected.covariance;
}

INSTANTIATE_TEST_SUITE_P(Seeds, CorrelativeMatcherOnRandomPoints, testing::Range(0, 60));

TEST(CorrelativeMatcher, RecoversALargeDisplacementInARoomToTheCellAndIsSureOfIt) {
  const SE2 map_T_reference{0.3, -0.4, 0.5};
  const synthetic::Laser laser{.beams = 360, .field_of_view_rad = 359.0 * kDeg};
  const CorrelativeMatcher matcher(
      {}, Moved(map_T_reference, PointsSeen(synthetic::Room(), map_T_reference, laser)));
  const SE2 truth{0.9, 0.2, 0.9};
  const CorrelativeMatch match =
      matcher.Match(PointsSeen(synthetic::Room(), truth, laser),
                    truth * SE2{-2.3, 1.1, -13.0 * kDeg}, {3.0, 15.0 * kDeg});
  ASSERT_TRUE(match.found);
  const SE2 error = Between(truth, match.map_T_scan);
  EXPECT_LT(error.translation().norm(), 0.05);
  EXPECT_LT(std::abs(error.theta), 1.0 * kDeg);
  EXPECT_LT(match.runner_up_score, 0.8 * match.score);
  EXPECT_LT(std::sqrt(match.covariance.topLeftCorner<2, 2>().eigenvalues().real().maxCoeff()), 0.1);
  EXPECT_LT(std::sqrt(match.covariance(2, 2)), 2.0 * kDeg);
}

TEST(CorrelativeMatcher, SaysThatAPositionAlongACorridorIsUncertainAndAmbiguous) {
  const double direction = 0.6;
  const synthetic::Walls corridor = synthetic::Corridor(direction);
  const SE2 along{0, 0, direction};
  const synthetic::Laser laser{.beams = 361, .field_of_view_rad = 359.0 * kDeg};
  Points reference;
  for (int i = -16; i <= 16; ++i) {
    const SE2 pose = along * SE2{0.5 * i, 0, 0};
    const Points seen = Moved(pose, PointsSeen(corridor, pose, laser));
    reference.insert(reference.end(), seen.begin(), seen.end());
  }
  const CorrelativeMatcher matcher({}, reference);
  const SE2 truth = along * SE2{0.2, 0.1, 0};
  const synthetic::Laser short_sighted{
      .beams = 361, .field_of_view_rad = 359.0 * kDeg, .usable_range_m = 5.0};
  const CorrelativeMatch match =
      matcher.Match(PointsSeen(corridor, truth, short_sighted), truth, {2.0, 10.0 * kDeg});
  ASSERT_TRUE(match.found);
  EXPECT_GT(match.runner_up_score, 0.97 * match.score);
  const Eigen::Vector2d u(std::cos(direction), std::sin(direction)), v(-u.y(), u.x());
  const Eigen::Matrix2d covariance = match.covariance.topLeftCorner<2, 2>();
  EXPECT_GT(std::sqrt(u.dot(covariance * u)), 0.2);
  EXPECT_LT(std::sqrt(v.dot(covariance * v)), 0.08);
}

TEST(CorrelativeMatcher, OfEquallyGoodPosesTakesThatNearestToTheInitialOne) {
  // Two places for one point, both in the middle of a cell.
  const CorrelativeMatcher matcher({}, {{1.025, 0.025}, {-1.025, 0.025}});
  for (const double x : {0.1, -0.1}) {
    const CorrelativeMatch match = matcher.Match({{0.025, 0.025}}, {x, 0, 0}, {2.0, 0.0});
    ASSERT_TRUE(match.found);
    EXPECT_DOUBLE_EQ(match.score, 1.0);
    EXPECT_DOUBLE_EQ(match.runner_up_score, 1.0);
    EXPECT_GT(match.map_T_scan.x * x, 0.0);
    // The other place is the second one.
    EXPECT_LT(match.runner_up_map_T_scan.x * x, 0.0);
    EXPECT_NEAR(std::abs(match.runner_up_map_T_scan.x), 1.0, 0.06);
  }
}

TEST(CorrelativeMatcher, TheSecondPoseIsTheBestOneWhereNothingElseIsNearlyAsGood) {
  const Points points = PointsSeen(synthetic::Room(), {});
  CorrelativeMatcher::Options options;
  options.runner_up_floor = 0.95;
  const CorrelativeMatch match =
      CorrelativeMatcher(options, points).Match(points, {0.1, 0.1, 0.1}, {1.0, 0.5});
  ASSERT_TRUE(match.found);
  EXPECT_DOUBLE_EQ(match.runner_up_score, 0.95 * match.score);
  EXPECT_TRUE((match.runner_up_map_T_scan == match.map_T_scan));
}

TEST(CorrelativeMatcher, ARotationByAFullTurnIsNotASecondPeak) {
  const Points points = PointsSeen(synthetic::Room(), {});
  const CorrelativeMatcher matcher({}, points);
  const CorrelativeMatch match =
      matcher.Match(points, {0, 0, std::numbers::pi}, {0.1, std::numbers::pi});
  ASSERT_TRUE(match.found);
  EXPECT_NEAR(backend::WrapAngle(match.map_T_scan.theta), 0.0, 0.01);
  EXPECT_LT(match.runner_up_score, 0.9 * match.score);
}

TEST(CorrelativeMatcher, FindsAPoseInAWindowLargerThanTheField) {
  const CorrelativeMatcher matcher({}, {{0.0, 0.0}, {0.3, 0.0}, {0.0, 0.5}});
  const CorrelativeMatch match =
      matcher.Match({{0.0, 0.0}, {0.3, 0.0}, {0.0, 0.5}}, {9.0, -9.0, 0.2}, {10.0, 20.0 * kDeg});
  ASSERT_TRUE(match.found);
  EXPECT_LT(match.map_T_scan.translation().norm(), 0.1);
}

TEST(CorrelativeMatcher, FindsNothingWithoutPointsOrReferenceOrOverlap) {
  const Points points = PointsSeen(synthetic::Room(), {});
  const SE2 initial{1, 2, 3};
  const CorrelativeMatch without_points = CorrelativeMatcher({}, points).Match({}, initial, {});
  EXPECT_FALSE(without_points.found);
  EXPECT_TRUE((without_points.map_T_scan == initial));
  EXPECT_FALSE(CorrelativeMatcher({}, {}).Match(points, initial, {3.0, 0.3}).found);
  for (const double far_m : {100.0, 1e7}) {
    const SE2 far_away{far_m, -far_m, 0};
    EXPECT_FALSE(CorrelativeMatcher({}, points).Match(points, far_away, {3.0, 0.3}).found);
  }
}

TEST(CorrelativeMatcher, FindsNothingBelowTheMinimumScore) {
  const Points points = PointsSeen(synthetic::Room(), {});
  const double score = CorrelativeMatcher({}, points).Match(points, {}, {0.5, 0.1}).score;
  CorrelativeMatcher::Options options;
  options.min_score = score;
  EXPECT_TRUE(CorrelativeMatcher(options, points).Match(points, {}, {0.5, 0.1}).found);
  options.min_score = score + 1e-6;
  EXPECT_FALSE(CorrelativeMatcher(options, points).Match(points, {}, {0.5, 0.1}).found);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
