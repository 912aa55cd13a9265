// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/motion_model.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Case {
  SE2 previous, u;
  double noise = 1.0;
};

class Sampling : public testing::TestWithParam<Case> {};

TEST_P(Sampling, HasTheMeanAndTheCovarianceOfTheClosedForm) {
  const auto& [previous, u, noise] = GetParam();
  const MotionModel model({});
  const SE2 mean = previous * u;
  const Matrix3d expected = model.Covariance(previous, u, noise);
  constexpr int kSamples = 20000;
  backend::CounterRandom random(3, 0);
  Vector3d sum = Vector3d::Zero();
  Matrix3d sum_of_squares = Matrix3d::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const SE2 sample = model.Sample(previous, u, noise, &random);
    const Vector3d d = Minus(sample, mean);
    sum += d;
    sum_of_squares += d * d.transpose();
  }
  // Five standard errors: of a mean sqrt(c_ii / n), of a covariance of normal numbers
  // sqrt((c_ii c_jj + c_ij^2) / n).
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(sum[i] / kSamples, 0.0, 5.0 * std::sqrt(expected(i, i) / kSamples));
    for (int j = 0; j < 3; ++j) {
      const double variance = expected(i, i) * expected(j, j) + expected(i, j) * expected(i, j);
      EXPECT_NEAR(sum_of_squares(i, j) / kSamples, expected(i, j),
                  5.0 * std::sqrt(variance / kSamples))
          << i << " " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MotionModel, Sampling,
                         testing::Values(Case{{0, 0, 0}, {0, 0, 0}}, Case{{0, 0, 0}, {1, 0, 0}},
                                         Case{{5, -3, 1.2}, {1, 0, 0}},
                                         Case{{5, -3, 1.2}, {1, 0, 0}, 0.1},
                                         Case{{5, -3, -2.5}, {0.4, 0.3, 0.5}},
                                         Case{{-1, 2, 3.1}, {-0.7, 0, 0.4}},
                                         Case{{0, 0, 0.7}, {0, 0, -0.5}}));

TEST(MotionModel, NoiseIsThatOfTheOptions) {
  const MotionModel model({.linear_per_linear = 0.1,
                           .linear_per_angular = 0.02,
                           .lateral_per_linear = 0.05,
                           .angular_per_linear = 0.3,
                           .angular_per_angular = 0.4,
                           .linear_floor_m = 0.001,
                           .angular_floor_rad = 0.002});
  const Vector3d sigmas = model.Sigmas({-3, 4, -0.5});
  EXPECT_NEAR(sigmas.x(), 0.001 + 0.1 * 3 + 0.05 * 4 + 0.02 * 0.5, 1e-12);
  EXPECT_NEAR(sigmas.y(), 0.001 + 0.1 * 4 + 0.05 * 3 + 0.02 * 0.5, 1e-12);
  EXPECT_NEAR(sigmas.z(), 0.002 + 0.3 * 5 + 0.4 * 0.5, 1e-12);
}

TEST(MotionModel, NoiseGrowsWithTheMotionAndDoesNotDependOnItsSign) {
  const MotionModel model({});
  for (const SE2& u : {SE2{1, 0, 0}, SE2{0, 1, 0}, SE2{0, 0, 1}, SE2{0.5, 0.2, 0.3}}) {
    const SE2 twice{2 * u.x, 2 * u.y, 2 * u.theta}, back{-u.x, -u.y, -u.theta};
    EXPECT_TRUE((model.Sigmas(twice).array() >= model.Sigmas(u).array()).all());
    EXPECT_GT(model.Sigmas(twice).sum(), model.Sigmas(u).sum());
    EXPECT_EQ(model.Sigmas(back), model.Sigmas(u));
  }
}

TEST(MotionModel, RobotThatStandsStillKeepsTheFloor) {
  const MotionModel model({.linear_floor_m = 0.02, .angular_floor_rad = 0.03});
  EXPECT_EQ(model.Sigmas({0, 0, 0}), Vector3d(0.02, 0.02, 0.03));
}

TEST(MotionModel, NoiseScalesTheStandardDeviations) {
  const MotionModel model({});
  const Matrix3d whole = model.Covariance({5, -3, 1.2}, {1, 0, 0.3}, 1.0);
  const Matrix3d tenth = model.Covariance({5, -3, 1.2}, {1, 0, 0.3}, 0.1);
  EXPECT_LT((100.0 * tenth - whole).norm(), 1e-12);
}

TEST(MotionModel, CovarianceTurnsWithTheHeading) {
  const MotionModel model({.linear_per_linear = 0.5, .lateral_per_linear = 0.1});
  const Matrix3d along_x = model.Covariance({0, 0, 0}, {1, 0, 0}, 1.0);
  const Matrix3d along_y = model.Covariance({7, 8, std::acos(0.0)}, {1, 0, 0}, 1.0);
  EXPECT_GT(along_x(0, 0), 10 * along_x(1, 1));
  EXPECT_NEAR(along_y(1, 1), along_x(0, 0), 1e-12);
  EXPECT_NEAR(along_y(0, 0), along_x(1, 1), 1e-12);
  const Matrix3d diagonal = model.Covariance({0, 0, std::acos(0.0) / 2}, {1, 0, 0}, 1.0);
  EXPECT_GT(diagonal(0, 1), 0.9 * (along_x(0, 0) - along_x(1, 1)) / 2);
}

// A curve of twenty scans.
Control Curve() {
  Control control;
  for (int scan = 0; scan < 20; ++scan) {
    control.increments.push_back({0.05, 0.002, 0.02});
    control.motion = control.motion * control.increments.back();
  }
  control.noise = 0.7;
  return control;
}

TEST(MotionModel, NoiseAtEachScanHasTheCovarianceOfTheWalk) {
  const MotionModel model({.linear_per_linear = 0.1, .noise_at_each_scan = true});
  const Control control = Curve();
  const SE2 previous{3, -1, 2.0}, mean = previous * control.motion;
  const Matrix3d expected = model.Covariance(previous, control);
  constexpr int kSamples = 20000;
  backend::CounterRandom random(4, 0);
  Matrix3d sum_of_squares = Matrix3d::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const SE2 sample = model.Sample(previous, control, &random);
    const Vector3d d = Minus(sample, mean);
    sum_of_squares += d * d.transpose();
  }
  EXPECT_LT((sum_of_squares / kSamples - expected).norm(), 0.05 * expected.norm());
}

// Independent errors partly cancel: of n scans 1 / sqrt(n) is left.
TEST(MotionModel, NoiseAtEachScanIsLessThanThatOfTheWholeMotion) {
  Control straight{.motion = {1.0, 0, 0}, .increments = std::vector<SE2>(25, SE2{0.04, 0, 0})};
  MotionModel::Options options{.linear_floor_m = 1e-9};
  const double once = MotionModel(options).Covariance({}, straight)(0, 0);
  options.noise_at_each_scan = true;
  EXPECT_NEAR(MotionModel(options).Covariance({}, straight)(0, 0), once / 25.0, 1e-6 * once);
}

TEST(MotionModel, AControlWithoutIncrementsIsOneScan) {
  MotionModel::Options options;
  const Control control{.motion = {0.3, 0, 0.1}};
  backend::CounterRandom once(5, 0), each(5, 0);
  const SE2 expected = MotionModel(options).Sample({}, control, &once);
  options.noise_at_each_scan = true;
  EXPECT_TRUE(MotionModel(options).Sample({}, control, &each) == expected);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
