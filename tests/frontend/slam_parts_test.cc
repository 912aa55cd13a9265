// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/slam_parts.h"

#include <gtest/gtest.h>

#include <memory>
#include <span>

namespace gmapping_spa::frontend {
namespace {

TEST(SlamParts, DefaultsOfThePartsAreThoseOfTheWhole) {
  EXPECT_EQ(GmappingOptions(SlamOptions{}), ImprovedGmapping::Options{});
}

TEST(SlamParts, ResolutionIsThatOfAllMaps) {
  const ImprovedGmapping::Options parts = GmappingOptions({.resolution_m = 0.1});
  EXPECT_EQ(parts.filter.grid.resolution_m, 0.1);
  EXPECT_EQ(parts.control.lidar_odometry.grid.resolution_m, 0.1);
  EXPECT_EQ(parts.loop_closer.verifier.grid.resolution_m, 0.1);
}

TEST(SlamParts, AllThatAlignScansDoItAlike) {
  SlamOptions options;
  options.match_noise_m = 0.05;
  options.match_robust_sigmas = 3.0;
  const ImprovedGmapping::Options parts = GmappingOptions(options);
  for (const scan_matching::GaussNewton::Options& aligns :
       {parts.filter.edges.gauss_newton, parts.control.lidar_odometry.gauss_newton,
        parts.loop_closer.verifier.gauss_newton, parts.final_optimization.gauss_newton}) {
    EXPECT_EQ(aligns.noise_sigma_m, 0.05);
    EXPECT_EQ(aligns.robust_sigmas, 3.0);
  }
}

TEST(SlamParts, SpeedLimitsHoldForWheelsAndScans) {
  SlamOptions options;
  options.max_speed_m_s = 2.0;
  options.max_turn_rad_s = 3.0;
  const ControlInput::Options control = GmappingOptions(options).control;
  EXPECT_EQ(control.check.max_speed_m_s, 2.0);
  EXPECT_EQ(control.lidar_odometry.prior.max_speed_m_s, 2.0);
  EXPECT_EQ(control.check.max_turn_rad_s, 3.0);
  EXPECT_EQ(control.lidar_odometry.prior.max_turn_rad_s, 3.0);
}

TEST(SlamParts, WithoutMatchedScansEdgesMeasureByParticle) {
  using Measurement = particle_filter::EdgeModel::Measurement;
  SlamOptions options;
  for (const auto& [odometry, measurement] :
       {std::pair{SlamOptions::Odometry::kRaw, Measurement::kParticle},
        {SlamOptions::Odometry::kWheel, Measurement::kParticle},
        {SlamOptions::Odometry::kLidar, Measurement::kControl},
        {SlamOptions::Odometry::kLidarOnly, Measurement::kControl}}) {
    options.odometry = odometry;
    EXPECT_EQ(GmappingOptions(options).filter.edges.measurement, measurement);
  }
}

// Notes the options of each call.
class Listener : public backend::Optimizer {
 public:
  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge>,
                            std::span<backend::Node>) override {
    calls.push_back(options);
    backend::Summary summary;
    summary.termination = backend::Termination::kConverged;
    return summary;
  }
  std::vector<backend::Options> calls;
};

TEST(SlamParts, TheOptimizerIsToldHowToOptimize) {
  SlamOptions options;
  options.optimizer.loss = {backend::LossKind::kHuber, 3.0};
  options.optimizer.max_iterations = 7;
  const auto optimizer = std::make_shared<Listener>();
  backend::PoseGraph graph{.nodes = {{.id = 0, .world_T_node = {}}}, .edges = {}};
  EXPECT_EQ(BindOptimizer(options, optimizer)(&graph).termination,
            backend::Termination::kConverged);
  ASSERT_EQ(optimizer->calls.size(), 1U);
  EXPECT_EQ(optimizer->calls[0], options.optimizer);
}

TEST(SlamParts, OnlyGncApproachesATruncatedLossGradually) {
  SlamOptions options;
  options.optimizer.loss = {backend::LossKind::kTruncated, 3.0};
  backend::PoseGraph graph{.nodes = {{.id = 0, .world_T_node = {}}, {.id = 1, .world_T_node = {}}},
                           .edges = {{.i = 0,
                                      .j = 1,
                                      .i_T_j = {9, 0, 0},
                                      .information = Eigen::Matrix3d::Identity(),
                                      .kind = backend::EdgeKind::kLoopClosure}}};
  const auto gradual = std::make_shared<Listener>(), direct = std::make_shared<Listener>();
  BindOptimizer(options, gradual)(&graph);
  EXPECT_GT(gradual->calls.size(), 1U);
  options.gnc = false;
  BindOptimizer(options, direct)(&graph);
  EXPECT_EQ(direct->calls.size(), 1U);
}

}  // namespace
}  // namespace gmapping_spa::frontend
