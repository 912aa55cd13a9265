// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/edge_model.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "frontend/particle_filter/motion_model.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Information = EdgeModel::Information;
using Measurement = EdgeModel::Measurement;
using Motion = TrajectoryTree::Motion;
using scan_matching::GaussNewton;
using scan_matching::ScanPoints;

EdgeModel::Options With(Measurement measurement) {
  EdgeModel::Options options;
  options.measurement = measurement;
  return options;
}

EdgeModel::Options With(Information information) {
  EdgeModel::Options options;
  options.information = information;
  return options;
}

// A step on the map of a room; its matrices are far from symmetric under rotation.
class OneStep : public testing::Test {
 protected:
  OneStep() {
    Eigen::Matrix3d root;
    root << 0.05, 0.0, 0.0, 0.02, 0.01, 0.0, 0.003, -0.002, 0.004;
    step_.world_T_previous = {0.3, -0.4, 2.2};
    step_.control = {0.25, 0.02, 0.15};
    step_.world_T_robot = step_.world_T_previous * SE2{0.3, -0.01, 0.1};
    step_.world_covariance = root * root.transpose();
    step_.matched = true;
    points_ =
        scan_matching::MakeScanPoints(synthetic::Scan(synthetic::Room(), step_.world_T_robot));
  }

  Motion Measured(const EdgeModel::Options& options) const {
    return EdgeModel(options).Measure(step_, grid_, points_);
  }

  // Expects the information to say of a displacement of the measured step what `in_world` says of
  // the displacement of the new pose that causes it.
  void ExpectSameStatement(const Eigen::Matrix3d& information,
                           const Eigen::Matrix3d& in_world) const {
    const Eigen::Vector3d displacements[] = {{1, 0, 0},  {0, 1, 0},   {0, 0, 1}, {1, 1, 0},
                                             {1, 0, -1}, {0, 1, 0.5}, {1, 2, 3}};
    for (const Eigen::Vector3d& world : displacements) {
      const SE2& a = step_.world_T_robot;
      const SE2 moved{a.x + 1e-3 * world.x(), a.y + 1e-3 * world.y(), a.theta + 1e-3 * world.z()};
      const SE2 before = Between(step_.world_T_previous, a);
      const SE2 after = Between(step_.world_T_previous, moved);
      const Eigen::Vector3d edge(after.x - before.x, after.y - before.y,
                                 after.theta - before.theta);
      const double expected = 1e-6 * world.dot(in_world * world);
      EXPECT_NEAR(edge.dot(information * edge), expected, 1e-6 * expected) << world.transpose();
    }
  }

  const map::OccupancyGrid grid_ = synthetic::RoomMap();
  EdgeModel::Step step_;
  ScanPoints points_;
};

TEST_F(OneStep, MeasurementIsTheStepOfTheParticleOrTheControlInput) {
  const Motion particle = Measured(With(Measurement::kParticle));
  EXPECT_TRUE(particle.previous_T_robot == Between(step_.world_T_previous, step_.world_T_robot));
  EXPECT_TRUE(particle.matched);
  const Motion control = Measured(With(Measurement::kControl));
  EXPECT_TRUE(control.previous_T_robot == step_.control);
  EXPECT_TRUE(control.matched);
  EXPECT_TRUE(control.information == particle.information);
}

TEST_F(OneStep, InformationIsInTheFrameOfThePreviousPose) {
  for (const double heading_rad : {0.0, 0.4, 1.5707963267948966, 2.2, -2.9}) {
    step_.world_T_previous.theta = heading_rad;
    ExpectSameStatement(Measured({}).information, step_.world_covariance.inverse());
  }
  // Nor is it that of the world by accident.
  EXPECT_FALSE(Measured({}).information.isApprox(step_.world_covariance.inverse(), 0.1));
}

TEST_F(OneStep, InformationIsSymmetricToTheBitAndPositiveDefinite) {
  for (const Information which :
       {Information::kProposal, Information::kHessian, Information::kConstant}) {
    const Eigen::Matrix3d information = Measured(With(which)).information;
    EXPECT_TRUE(information == information.transpose());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information).eigenvalues()(0), 0.0);
  }
}

TEST_F(OneStep, HessianIsThatOfScanMatchingAtTheNewPose) {
  EdgeModel::Options options = With(Information::kHessian);
  options.hessian_gain = 0.25;
  options.gauss_newton.noise_sigma_m = 0.05;
  const Eigen::Matrix3d matching =
      GaussNewton(options.gauss_newton).InformationAt(grid_, points_, step_.world_T_robot);
  ExpectSameStatement(Measured(options).information, 0.25 * matching + GaussNewton::WeakPrior());
}

TEST_F(OneStep, HessianOfAScanThatMeetsNothingIsTheWeakPrior) {
  const EdgeModel model(With(Information::kHessian));
  const Motion motion = model.Measure(step_, map::OccupancyGrid({}), points_);
  EXPECT_TRUE(motion.information.isApprox(GaussNewton::WeakPrior(), 1e-9));
}

TEST_F(OneStep, ConstantInformationIsInverseToTheSquaredSigmasWhateverTheHeading) {
  EdgeModel::Options options = With(Information::kConstant);
  options.constant_sigma_m = 0.2;
  options.constant_sigma_rad = 0.1;
  const Eigen::Matrix3d expected = Eigen::Vector3d(25.0, 25.0, 100.0).asDiagonal();
  EXPECT_TRUE(Measured(options).information.isApprox(expected, 1e-9));
  step_.world_T_previous.theta = -0.7;
  EXPECT_TRUE(Measured(options).information.isApprox(expected, 1e-9));
}

TEST_F(OneStep, WithoutAMatchTheMotionModelIsAllThereIs) {
  const MotionModel motion_model({});
  step_.matched = false;
  step_.world_covariance = motion_model.Covariance(step_.world_T_previous, step_.control, 1.0);
  // The motion model's noise has the axes of the previous pose, as an edge has.
  const Eigen::Matrix3d expected =
      motion_model.Sigmas(step_.control).array().square().inverse().matrix().asDiagonal();
  for (const Information which :
       {Information::kProposal, Information::kHessian, Information::kConstant}) {
    const Motion motion = Measured(With(which));
    EXPECT_FALSE(motion.matched);
    EXPECT_TRUE(motion.information.isApprox(expected, 1e-9));
  }
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
