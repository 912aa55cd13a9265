// SPDX-License-Identifier: BSD-3-Clause
// ImprovedGmapping on a drive around a loop: what its back end does for it, and when.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "tests/frontend/loop_drive.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::SE2;
using OptimizeFunction = GraphThread::OptimizeFunction;

TEST_F(LoopDrive, WheelsAloneLeadAstray) {
  const SE2 truth = Between(truth_.front(), truth_.back());
  const SE2 wheels = Between(scans_.front().odom_T_robot, scans_.back().odom_T_robot);
  EXPECT_GT(Between(truth, wheels).translation().norm(), 2.0);
}

TEST_F(LoopDrive, EndsNearTheTruth) {
  const auto gmapping = Drive(Options(), Spa());
  const SlamResult estimate = gmapping->Finish();
  EXPECT_LT(LargestError(estimate.trajectory), 0.15);
  EXPECT_GE(gmapping->loop_closer().closures().size(), 2u);
  EXPECT_GT(gmapping->counts().corrections, 0);
  EXPECT_EQ(gmapping->graph_thread().counts().failed, 0);
  EXPECT_EQ(estimate.graph.nodes.size(), static_cast<std::size_t>(gmapping->counts().updates));
  EXPECT_EQ(estimate.graph.edges.size(),
            estimate.graph.nodes.size() - 1 + gmapping->loop_closer().closures().size());
}

// With it the filter drives blindly: nothing but the back end corrects the wheels.
class FailingMatcher : public scan_matching::ScanMatcher {
 public:
  scan_matching::MatchResult Match(const map::OccupancyGrid&, const scan_matching::ScanPoints&,
                                   const SE2& initial_world_T_robot,
                                   const Eigen::Matrix3d&) const override {
    return {false, initial_world_T_robot, 0.0};
  }
};

TEST_F(LoopDrive, ClosedLoopsCorrectTheParticles) {
  ImprovedGmapping::Options options = Options();
  options.control.source = OdometrySource::kWheel;
  options.make_final_optimization = false;
  options.filter.particles = 1;
  options.filter.edges.measurement = particle_filter::EdgeModel::Measurement::kParticle;
  options.filter.motion = {.linear_per_linear = 0.01,
                           .linear_per_angular = 0.01,
                           .lateral_per_linear = 0.01,
                           .angular_per_linear = 0.001,
                           .angular_per_angular = 0.001,
                           .linear_floor_m = 0.001,
                           .angular_floor_rad = 0.0005};
  const std::vector<SE2> wheels = synthetic::WithDrift(
      truth_, {.scale = 1.01, .rad_per_m = 0.0015, .lateral_per_m = 0.008}, {});
  const auto last_error = [&](ImprovedGmapping::Correction correction, OptimizeFunction optimize) {
    options.correction = correction;
    ImprovedGmapping gmapping(options, std::make_shared<FailingMatcher>(), std::move(optimize));
    for (std::size_t k = 0; k < scans_.size(); ++k) {
      sensor::LaserScan scan = scans_[k];
      scan.odom_T_robot = wheels[k];
      gmapping.AddScan(scan);
    }
    const SE2 last = gmapping.Finish().trajectory.back().world_T_robot;
    return Between(Between(truth_.front(), truth_.back()), last).translation().norm();
  };
  const double uncorrected = last_error(ImprovedGmapping::Correction::kTrajectory, NoBackEnd);
  EXPECT_GT(uncorrected, 0.5);
  EXPECT_LT(last_error(ImprovedGmapping::Correction::kTrajectory, Spa()), 0.5 * uncorrected);
  EXPECT_LT(last_error(ImprovedGmapping::Correction::kPose, Spa()), 0.5 * uncorrected);
}

TEST_F(LoopDrive, CorrectionIsOfTheCurrentPoseOrOfTheWholeTrajectory) {
  // A back end that moves node k by 0.1 k metres.
  const auto shift = [](PoseGraph* graph) {
    for (std::size_t k = 0; k < graph->nodes.size(); ++k) {
      graph->nodes[k].world_T_node.x += 0.1 * static_cast<double>(k);
    }
    return NoBackEnd(graph);
  };
  ImprovedGmapping::Options options = Options();
  options.linear_update_m = 0.2;  // every scan, but for one without motion
  options.optimize_every = 5;
  options.graph_thread.mode = GraphThread::Mode::kInline;
  for (const auto correction :
       {ImprovedGmapping::Correction::kPose, ImprovedGmapping::Correction::kTrajectory}) {
    options.correction = correction;
    ImprovedGmapping gmapping(
        options,
        std::make_shared<scan_matching::GaussNewtonMatcher>(
            scan_matching::GaussNewtonMatcher::Options{}, options.filter.endpoint),
        shift);
    for (int k = 0; k < 5; ++k) gmapping.AddScan(scans_[k]);
    ASSERT_TRUE(gmapping.graph_thread().busy());
    const std::vector<SE2> before = backend::PosesOf(gmapping.CurrentResult().graph);
    sensor::LaserScan again = scans_[4];
    again.index = 5;
    again.stamp_s += 1.0;  // time to stop
    gmapping.AddScan(again);
    EXPECT_EQ(gmapping.counts().corrections, 1);
    const SlamResult estimate = gmapping.CurrentResult();
    const std::vector<SE2> after = backend::PosesOf(estimate.graph);
    ASSERT_EQ(after.size(), 5u);
    for (int k = 0; k < 5; ++k) {
      const bool moves = k == 4 || correction == ImprovedGmapping::Correction::kTrajectory;
      EXPECT_NEAR(after[k].x - before[k].x, moves ? 0.1 * k : 0.0, 1e-9) << k;
      EXPECT_NEAR(after[k].y, before[k].y, 1e-9) << k;
    }
    EXPECT_NEAR(estimate.trajectory.back().world_T_robot.x, after.back().x, 0.05);
  }
}

TEST_F(LoopDrive, EstimateOnTheWayHasEverythingSoFar) {
  const auto gmapping = Drive(Options(), Spa());
  const SlamResult estimate = gmapping->CurrentResult();
  EXPECT_LT(LargestError(estimate.trajectory), 0.2);
  EXPECT_EQ(estimate.graph.nodes.size(), static_cast<std::size_t>(gmapping->counts().updates));
  for (std::size_t k = 0; k < scans_.size(); k += 20) {
    const SE2 world_T_robot = Between(truth_.front(), truth_[k]);
    EXPECT_GT(synthetic::FittingPart(estimate.map, scans_[k], world_T_robot), 0.92) << k;
  }
}

TEST_F(LoopDrive, OptimizesAfterSoManyUpdatesAndAfterAClosure) {
  ImprovedGmapping::Options options = Options();
  options.make_final_optimization = false;
  options.close_loops = false;
  options.optimize_every = 10;
  const auto gmapping = Drive(options, NoBackEnd);
  EXPECT_EQ(gmapping->graph_thread().counts().started, gmapping->counts().updates / 10);
  options.optimize_every = 1000;
  EXPECT_EQ(Drive(options, NoBackEnd)->graph_thread().counts().started, 0);
  options.close_loops = true;
  EXPECT_GT(Drive(options, NoBackEnd)->graph_thread().counts().started, 0);
}

TEST_F(LoopDrive, OdometryThatJumpsOffTheMapIsLeftOut) {
  for (const SE2 jump : {SE2{2e4, 0, 0}, SE2{-1e9, 0, 0}, SE2{0, 1e300, 0}}) {
    const auto gmapping = Drive(Options(), NoBackEnd, 40);
    const SE2 before = gmapping->CurrentResult().trajectory.back().world_T_robot;
    sensor::LaserScan scan = scans_[39];
    scan.index = 40;
    scan.stamp_s += 0.1;
    scan.odom_T_robot = scan.odom_T_robot * jump;
    gmapping->AddScan(scan);
    const SE2 after = gmapping->CurrentResult().trajectory.back().world_T_robot;
    // It may have gone on by a step, as before.
    EXPECT_LT(Between(before, after).translation().norm(), 0.5) << jump.x;
    EXPECT_EQ(gmapping->health().findings().count("odometry_impossible"), 1u) << jump.x;
  }
}

}  // namespace
}  // namespace gmapping_spa::frontend
