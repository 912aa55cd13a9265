// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/proposal.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "backend/counter_random.h"
#include "frontend/particle_filter/motion_model.h"
#include "frontend/scan_matching/hill_climbing.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scan_matching::EndpointModel;
using scan_matching::MakeScanPoints;
using scan_matching::ScanPoints;

// As wide as that of gmapping_plus.flags, so that a corridor shows.
const MotionModel kMotionModel({.linear_per_linear = 0.2,
                                .linear_per_angular = 0.1,
                                .lateral_per_linear = 0.1,
                                .angular_per_linear = 0.2,
                                .angular_per_angular = 0.2});

// After a metre straight on, predicted slightly beside the truth.
PoseGaussian PriorNear(const SE2& truth) {
  const SE2 previous = truth * SE2{-1, 0, 0};
  return {truth * SE2{0.02, -0.01, 0.01}, kMotionModel.Covariance(previous, {1, 0, 0}, 1.0)};
}

Proposal MatchAndPropose(const map::OccupancyGrid& grid, const ScanPoints& points,
                         const PoseGaussian& prior, EndpointModel* model) {
  const scan_matching::HillClimbing matcher({}, {});
  return ComputeProposal(
      model, matcher.Match(grid, points, prior.mean, prior.covariance.inverse()).world_T_robot,
      prior);
}

// Standard deviation of the position in the direction.
double Deviation(const Matrix3d& covariance, double direction_rad) {
  const Vector3d direction(std::cos(direction_rad), std::sin(direction_rad), 0.0);
  return std::sqrt(direction.dot(covariance * direction));
}

TEST(ComputeProposal, IsWideAlongACorridorAndNarrowAcrossIt) {
  for (const double range_m : {5.0, 20.0}) {
    for (const double direction_rad : {0.0, 0.1, 0.3, 0.5, 0.8, 1.2, 1.57, 2.2, -0.5}) {
      const synthetic::Laser laser{.usable_range_m = range_m};
      const map::OccupancyGrid grid = synthetic::CorridorMap(direction_rad, laser);
      const SE2 truth{0.03, 0.02, direction_rad + 0.2};
      const ScanPoints points =
          MakeScanPoints(synthetic::Scan(synthetic::Corridor(direction_rad), truth, laser));
      EndpointModel model({}, &grid, &points);
      const PoseGaussian prior = PriorNear(truth);
      const Matrix3d covariance = MatchAndPropose(grid, points, prior, &model).gaussian.covariance;
      const double along_m = Deviation(covariance, direction_rad);
      const double across_m = Deviation(covariance, direction_rad + std::numbers::pi / 2);
      EXPECT_GT(along_m, 10.0 * across_m) << direction_rad << ", range " << range_m;
      EXPECT_LT(across_m, 0.01) << direction_rad << ", range " << range_m;
      EXPECT_LT(along_m, 1.1 * Deviation(prior.covariance, direction_rad)) << direction_rad;
    }
  }
}

TEST(ComputeProposal, IsNarrowInARoomWithWallsInTwoDirections) {
  const map::OccupancyGrid grid = synthetic::RoomMap();
  for (const double heading_rad : {0.0, 1.0, 2.5, -2.0}) {
    const SE2 truth{0.3, -0.2, heading_rad};
    const ScanPoints points = MakeScanPoints(synthetic::Scan(synthetic::Room(), truth));
    EndpointModel model({}, &grid, &points);
    const Proposal proposal = MatchAndPropose(grid, points, PriorNear(truth), &model);
    for (int k = 0; k < 8; ++k) EXPECT_LT(Deviation(proposal.gaussian.covariance, 0.4 * k), 0.02);
    EXPECT_LT(std::sqrt(proposal.gaussian.covariance(2, 2)), 0.01);
    const SE2 error = Between(truth, proposal.gaussian.mean);
    EXPECT_LT(error.translation().norm(), 0.015);
    EXPECT_LT(std::abs(error.theta), 0.005);
  }
}

TEST(ComputeProposal, MeanRecoversAPerturbedPoseToACentimetreAndAFifthOfADegree) {
  constexpr double kDeg = std::numbers::pi / 180.0;
  const map::OccupancyGrid grid = synthetic::RoomMap();
  for (int trial = 0; trial < 300; ++trial) {
    backend::CounterRandom random(11, 0, trial);
    const auto offset = [&](double limit) { return limit * (2.0 * random.Uniform() - 1.0); };
    const SE2 truth{offset(1.0), offset(1.0), offset(3.0)};
    const ScanPoints points = MakeScanPoints(synthetic::Scan(synthetic::Room(), truth));
    const SE2 predicted = truth * SE2{offset(0.1), offset(0.1), offset(4.0 * kDeg)};
    EndpointModel model({}, &grid, &points);
    const PoseGaussian prior{predicted,
                             kMotionModel.Covariance(predicted * SE2{-1, 0, 0}, {1, 0, 0}, 1.0)};
    const SE2 error = Between(truth, MatchAndPropose(grid, points, prior, &model).gaussian.mean);
    EXPECT_LT(error.translation().norm(), 0.01) << trial;
    EXPECT_LT(std::abs(error.theta), 0.2 * kDeg) << trial;
  }
}

TEST(ComputeProposal, IsTheClosedFormOnAGaussianTarget) {
  // Forty lonely cells, each hit in its center, and a scan whose points are exactly there: the
  // log likelihood is a sum of squared distances, and the prior is Gaussian anyway.
  map::OccupancyGrid grid({.resolution_m = 0.05});
  ScanPoints points;
  const SE2 truth{0.0, 0.0, 0.0};
  const double sigma_m = 0.05;
  Matrix3d information = Matrix3d::Zero();
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 40.0, radius = i % 3 == 0 ? 2.0 : 1.8;
    const Eigen::Vector2d hit(std::floor(radius * std::cos(angle) * 20) + 0.5,
                              std::floor(0.7 * radius * std::sin(angle) * 20) + 0.5);
    grid.AddHit(hit.x(), hit.y());
    const Eigen::Vector2d point = 0.05 * hit, back = -point.normalized();
    points.push_back({point.x(), point.y(), back.x(), back.y()});
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << 1, 0, -point.y(), 0, 1, point.x();
    information += jacobian.transpose() * jacobian / (sigma_m * sigma_m);
  }
  EndpointModel model(
      {.likelihood_sigma_m = sigma_m, .unmatched_sigmas = 20.0, .likelihood_gain = 1.0}, &grid,
      &points);
  Matrix3d prior_covariance;  // as narrow as the likelihood
  prior_covariance << 1e-4, 2e-5, 0, 2e-5, 6e-5, 1e-5, 0, 1e-5, 5e-5;
  const PoseGaussian prior{{0.005, -0.004, 0.003}, prior_covariance};
  const Matrix3d prior_information = prior_covariance.inverse();

  const Matrix3d covariance = (information + prior_information).inverse();
  const Vector3d innovation = Minus(prior.mean, truth);
  const Vector3d mean = covariance * prior_information * innovation;
  // The integral of exp(-x' A x / 2) N(x; b, P) over x.
  const Matrix3d sum = information.inverse() + prior_covariance;
  const double log_eta = 0.5 * std::log(information.inverse().determinant() / sum.determinant()) -
                         0.5 * innovation.dot(sum.inverse() * innovation);

  const Proposal proposal = ComputeProposal(&model, truth, prior);
  const Matrix3d root = covariance.llt().matrixL();
  const Matrix3d unit = root.inverse() * proposal.gaussian.covariance * root.inverse().transpose();
  // Three samples to an axis have 0.93 of the variance; one lattice is not quite that of the sum.
  EXPECT_LT((unit - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.2) << unit;
  EXPECT_LT((root.inverse() * (Minus(proposal.gaussian.mean, truth) - mean)).norm(), 0.15);
  EXPECT_NEAR(proposal.log_eta, log_eta, 0.1);
}

struct Moments {
  Vector3d mean = Vector3d::Zero();  // relative to the center
  Matrix3d covariance = Matrix3d::Zero();
  double log_integral = 0.0;
};

// Of p(z | m, x) p(x | x', u), from a dense lattice of 31^3 poses out to 6 standard deviations of
// the Gaussian `around`, taken 1.5 times as wide as it says.
Moments BruteForce(EndpointModel* model, const PoseGaussian& prior, const PoseGaussian& around) {
  constexpr int kHalf = 15;
  const Matrix3d root = around.covariance.llt().matrixL();
  const Matrix3d step = 1.5 * 4.0 / kHalf * root;
  const Matrix3d information = prior.covariance.inverse();
  const double log_scale =
      -0.5 * std::log(prior.covariance.determinant()) - 1.5 * std::log(2.0 * std::numbers::pi);
  const double reference = model->LogLikelihood(around.mean);
  double sum = 0.0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (int i = -kHalf; i <= kHalf; ++i) {
    for (int j = -kHalf; j <= kHalf; ++j) {
      for (int k = -kHalf; k <= kHalf; ++k) {
        const Vector3d offset = step * Vector3d(i, j, k);
        const SE2 pose = Plus(around.mean, offset);
        const Vector3d innovation = Minus(pose, prior.mean);
        const double weight = std::exp(model->LogLikelihood(pose) - reference + log_scale -
                                       0.5 * innovation.dot(information * innovation));
        sum += weight;
        first += weight * offset;
        second += weight * offset * offset.transpose();
      }
    }
  }
  Moments moments;
  moments.mean = first / sum;
  moments.covariance = second / sum - moments.mean * moments.mean.transpose();
  moments.log_integral = reference + std::log(sum * step.determinant());
  return moments;
}

// How far a proposal is from the integral of its target.
struct Disagreement {
  double log_eta = 0.0;
  double mean = 0.0;      // in standard deviations
  double smallest = 0.0;  // part of the exact variance that it has, in the direction of least
  double largest = 0.0;
};

// Of a scan of 61 beams at `truth`.
Disagreement CompareWithIntegral(const synthetic::Walls& walls, const map::OccupancyGrid& grid,
                                 const SE2& truth) {
  const ScanPoints points = MakeScanPoints(synthetic::Scan(walls, truth, {.beams = 61}));
  EndpointModel model({}, &grid, &points);
  const PoseGaussian prior = PriorNear(truth);
  const Proposal proposal = MatchAndPropose(grid, points, prior, &model);
  const Moments exact = BruteForce(&model, prior, proposal.gaussian);
  const Matrix3d root = exact.covariance.llt().matrixL();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> ratio(
      root.inverse() * proposal.gaussian.covariance * root.inverse().transpose());
  return {.log_eta = std::abs(proposal.log_eta - exact.log_integral),
          .mean = (root.inverse() * exact.mean).norm(),
          .smallest = ratio.eigenvalues().minCoeff(),
          .largest = ratio.eigenvalues().maxCoeff()};
}

TEST(ComputeProposal, AgreesWithDenseIntegrationInARoom) {
  const map::OccupancyGrid grid = synthetic::RoomMap();
  for (int trial = 1; trial < 12; trial += 2) {
    const SE2 truth{0.04 * trial, 0.03 * trial, 0.25 * trial};
    const Disagreement found = CompareWithIntegral(synthetic::Room(), grid, truth);
    EXPECT_LT(found.log_eta, 0.12) << trial;
    EXPECT_LT(found.mean, 0.25) << trial;
    EXPECT_GT(found.smallest, 0.7) << trial;
    EXPECT_LT(found.largest, 1.4) << trial;
  }
}

// Along a corridor the target is not always Gaussian: where hits are sparse, beams find and lose
// the surface that explains them. So most of the trials must agree closely, and none be wider than
// the target.
TEST(ComputeProposal, AgreesWithDenseIntegrationInACorridor) {
  int close = 0;
  for (int trial = 0; trial < 12; trial += 2) {
    const double direction_rad = 0.25 * trial;
    const SE2 truth{0.04 * trial, 0.03 * trial, direction_rad + 0.1};
    const Disagreement found = CompareWithIntegral(synthetic::Corridor(direction_rad),
                                                   synthetic::CorridorMap(direction_rad), truth);
    close += found.log_eta < 0.06 && found.mean < 0.08 && found.smallest > 0.78;
    EXPECT_LT(found.log_eta, 1.5) << trial;
    EXPECT_LT(found.mean, 0.75) << trial;
    EXPECT_LT(found.largest, 1.02) << trial;
  }
  EXPECT_GE(close, 4);
}

TEST(ComputeProposal, IsThePriorWhereTheMapSaysNothing) {
  const map::OccupancyGrid empty({});
  const ScanPoints points(5, {1.0, 0.0, -1.0, 0.0});
  EndpointModel model({}, &empty, &points);
  const PoseGaussian prior = PriorNear({1, 2, 0.5});
  const Proposal proposal = ComputeProposal(&model, prior.mean, prior);
  EXPECT_LT(Minus(proposal.gaussian.mean, prior.mean).norm(), 1e-9);
  const Matrix3d unit = prior.covariance.inverse() * proposal.gaussian.covariance;
  EXPECT_LT((unit - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_NEAR(proposal.log_eta, model.LogLikelihood(prior.mean), 0.02);
}

TEST(SampleGaussian, HasTheMeanAndTheCovarianceOfTheGaussian) {
  PoseGaussian gaussian{{1, -2, 3.1}, Matrix3d::Zero()};  // across the end of the circle
  gaussian.covariance << 0.04, 0.01, -0.005, 0.01, 0.02, 0.003, -0.005, 0.003, 0.01;
  backend::CounterRandom random(5, 0);
  constexpr int kSamples = 20000;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const SE2 sample = SampleGaussian(gaussian, &random);
    EXPECT_LE(std::abs(sample.theta), std::numbers::pi);
    const Vector3d d = Minus(sample, gaussian.mean);
    first += d;
    second += d * d.transpose();
  }
  const Matrix3d& expected = gaussian.covariance;
  for (int i = 0; i < 3; ++i) {  // five standard errors
    EXPECT_NEAR(first[i] / kSamples, 0.0, 5.0 * std::sqrt(expected(i, i) / kSamples));
    for (int j = 0; j < 3; ++j) {
      const double variance = expected(i, i) * expected(j, j) + expected(i, j) * expected(i, j);
      EXPECT_NEAR(second(i, j) / kSamples, expected(i, j), 5.0 * std::sqrt(variance / kSamples));
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
