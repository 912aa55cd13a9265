// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/improved_gmapping.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontend/scan_matching/hill_climbing.h"
#include "tests/frontend/room_map.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::SE2;

// With a back end that does nothing, the wheels' odometry and hill climbing.
class PlainGmapping : public testing::Test {
 protected:
  void Start(double linear_update_m, double angular_update_rad) {
    ImprovedGmapping::Options options;
    options.linear_update_m = linear_update_m;
    options.angular_update_rad = angular_update_rad;
    options.filter.particles = 3;
    options.filter.match_start.guesses = guesses_;
    options.filter.proposal = proposal_;
    options.control.source = OdometrySource::kWheel;
    options.filter.edges.measurement = particle_filter::EdgeModel::Measurement::kParticle;
    options.control.check.max_speed_m_s = max_speed_m_s_;
    options.close_loops = false;
    options.make_final_optimization = false;
    gmapping_ = std::make_unique<ImprovedGmapping>(
        options,
        std::make_shared<scan_matching::HillClimbing>(scan_matching::HillClimbing::Options{},
                                                      options.filter.endpoint),
        DoNothing);
  }

  static backend::Summary DoNothing(PoseGraph*) {
    backend::Summary summary;
    summary.termination = backend::Termination::kConverged;
    return summary;
  }

  // Adds a scan and tells whether it led to an update.
  bool Add(const SE2& world_T_robot) {
    sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), world_T_robot, {.beams = 181});
    scan.index = next_index_++;
    scan.stamp_s = 0.1 * static_cast<double>(scan.index);
    scan.odom_T_robot = odom_T_world_ * world_T_robot;
    const std::int64_t before = gmapping_->counts().updates;
    gmapping_->AddScan(scan);
    return gmapping_->counts().updates > before;
  }

  // Some curve with four updates after the first.
  void AddDrive() {
    Start(0.5, 10.0);
    for (int i = 0; i <= 17; ++i) {
      Add({0.125 * i, 0.02 * i, 0.05 * i});
    }
  }

  const SE2 odom_T_world_{30, -20, 2.0};
  double max_speed_m_s_ = 10.0;
  int guesses_ = 3;
  particle_filter::PoseSampling::Kind proposal_ = particle_filter::PoseSampling::Kind::kGaussian;
  std::int64_t next_index_ = 0;
  std::unique_ptr<ImprovedGmapping> gmapping_;
};

TEST_F(PlainGmapping, UpdatesWithTheFirstScanAndWhenItHasDrivenFarEnough) {
  Start(0.5, 0.25);
  std::vector<bool> updates;
  for (const double x : {0.0, 0.25, 0.4375, 0.5625, 0.8125, 1.0, 1.125})
    updates.push_back(Add({x, 0, 0}));
  EXPECT_EQ(updates, (std::vector<bool>{true, false, false, true, false, false, true}));
}

TEST_F(PlainGmapping, UpdatesWhenItHasTurnedFarEnough) {
  Start(0.5, 0.25);
  std::vector<bool> updates;
  for (const double theta : {0.0, 0.1, 0.24, 0.26, 0.4, 0.5, 0.52})
    updates.push_back(Add({0, 0, theta}));
  EXPECT_EQ(updates, (std::vector<bool>{true, false, false, true, false, false, true}));
}

TEST_F(PlainGmapping, WayThereAndBackCounts) {
  Start(0.5, 10.0);
  EXPECT_TRUE(Add({0, 0, 0}));
  EXPECT_FALSE(Add({0.3, 0, 0}));
  EXPECT_TRUE(Add({0.05, 0, 0}));
}

TEST_F(PlainGmapping, ThresholdsOfZeroUpdateWithEveryScan) {
  Start(0.0, 0.0);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(Add({0, 0, 0}));
}

TEST_F(PlainGmapping, GraphIsAChainOfOneNodeAnUpdate) {
  AddDrive();
  const PoseGraph graph = gmapping_->CurrentResult().graph;
  const std::int64_t updates = gmapping_->counts().updates;
  ASSERT_GE(updates, 4);
  ASSERT_EQ(graph.nodes.size(), static_cast<std::size_t>(updates));
  ASSERT_EQ(graph.edges.size(), static_cast<std::size_t>(updates - 1));
  for (std::int64_t i = 0; i < updates; ++i) EXPECT_EQ(graph.nodes[i].id, i);
  EXPECT_TRUE((graph.nodes[0].world_T_node == SE2{}));
  for (std::int64_t i = 0; i + 1 < updates; ++i) {
    EXPECT_EQ(graph.edges[i].i, i);
    EXPECT_EQ(graph.edges[i].j, i + 1);
    EXPECT_EQ(graph.edges[i].kind, backend::EdgeKind::kScanMatch);
    EXPECT_LT(graph.nodes[i].stamp_s, graph.nodes[i + 1].stamp_s);
  }
}

TEST_F(PlainGmapping, InformationIsSymmetricAndPositiveDefinite) {
  AddDrive();
  const PoseGraph graph = gmapping_->CurrentResult().graph;
  ASSERT_GE(graph.edges.size(), 3u);
  for (const backend::Edge& edge : graph.edges) {
    EXPECT_TRUE(edge.information == edge.information.transpose());
    EXPECT_EQ(edge.information.llt().info(), Eigen::Success);
    EXPECT_GT(edge.information(0, 0), 1.0 / (0.1 * 0.1));
  }
}

TEST_F(PlainGmapping, InformationIsInTheFrameOfTheNodeTheEdgeStartsAt) {
  // Blind scans: the motion model's covariance remains, which is diagonal in the robot's frame.
  Start(0.5, 10.0);
  sensor::LaserScan scan;
  for (const SE2& pose : {SE2{0, 0, 0}, SE2{0.5, 0, 0.9}, SE2{0.5, 0, 0.9} * SE2{1, 0, 0}}) {
    scan.odom_T_robot = pose;
    scan.stamp_s += 1.0;
    gmapping_->AddScan(scan);
  }
  const PoseGraph graph = gmapping_->CurrentResult().graph;
  ASSERT_EQ(graph.edges.size(), 2u);
  const backend::Edge& edge = graph.edges[1];
  EXPECT_EQ(edge.kind, backend::EdgeKind::kOdometry);
  const Eigen::Vector3d sigmas = particle_filter::MotionModel({}).Sigmas({1, 0, 0});
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(edge.information(i, i) * sigmas[i] * sigmas[i], 1.0, 1e-6);
    EXPECT_NEAR(edge.information(i, (i + 1) % 3), 0.0, 1e-6);
  }
}

TEST_F(PlainGmapping, EdgesMeasureWhatIsBetweenTheNodes) {
  AddDrive();
  const PoseGraph graph = gmapping_->CurrentResult().graph;
  ASSERT_GE(graph.edges.size(), 3u);
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const SE2 step = Between(graph.nodes[i].world_T_node, graph.nodes[i + 1].world_T_node);
    EXPECT_LT(Log(Between(graph.edges[i].i_T_j, step)).norm(), 1e-12) << i;
  }
}

TEST_F(PlainGmapping, TrajectoryHasAPoseForEveryScanInTheFrameOfTheFirst) {
  AddDrive();
  const SlamResult estimate = gmapping_->Finish();
  const backend::Trajectory& trajectory = estimate.trajectory;
  ASSERT_EQ(trajectory.size(), 18u);
  EXPECT_EQ(gmapping_->counts().scans, 18);
  EXPECT_LT(Log(trajectory[0].world_T_robot).norm(), 1e-12);
  for (int i = 0; i < 18; ++i) {
    const SE2 truth{0.125 * i, 0.02 * i, 0.05 * i};
    EXPECT_DOUBLE_EQ(trajectory[i].stamp_s, 0.1 * i);
    EXPECT_LT(Between(truth, trajectory[i].world_T_robot).translation().norm(), 0.05) << i;
    const sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), truth);
    EXPECT_GT(synthetic::FittingPart(estimate.map, scan, truth), 0.98) << i;
  }
}

TEST_F(PlainGmapping, LeavesOutAStepThatNoRobotMakes) {
  Start(0.5, 10.0);
  for (int i = 0; i <= 10; ++i) Add({0.1 * i, 0, 0});
  const SE2 before = gmapping_->CurrentResult().trajectory.back().world_T_robot;
  const SE2 jump{2e4, 0, 0};
  sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), {1.0, 0, 0}, {.beams = 91});
  scan.stamp_s = 1.1;
  scan.odom_T_robot = odom_T_world_ * SE2{1.0, 0, 0} * jump;
  gmapping_->AddScan(scan);
  const SlamResult estimate = gmapping_->Finish();
  EXPECT_LT(Log(Between(before, estimate.trajectory.back().world_T_robot)).norm(), 0.05);
  ASSERT_EQ(gmapping_->health().findings().count("odometry_impossible"), 1u);
  EXPECT_EQ(gmapping_->health().findings().at("odometry_impossible").first_stamp_s, 1.1);
}

TEST_F(PlainGmapping, ParticlesThatAreCopiesOfOneAreReported) {
  proposal_ = particle_filter::PoseSampling::Kind::kMatch;
  Start(0.5, 0.5);
  Add({});
  EXPECT_TRUE(gmapping_->health().findings().empty());
  guesses_ = 0;
  Start(0.5, 0.5);
  Add({});
  EXPECT_EQ(gmapping_->health().findings().count("particles_alike"), 1u);
}

TEST_F(PlainGmapping, RefusesOdometryThatLeadsOffTheMap) {
  for (const SE2 jump : {SE2{2e4, 0, 0}, SE2{2e3, 2e3, 0}, SE2{-1e9, 0, 0}, SE2{0, 1e300, 0}}) {
    next_index_ = 0;
    max_speed_m_s_ = std::numeric_limits<double>::infinity();
    Start(0.5, 10.0);
    Add({0, 0, 0});
    sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), {});
    scan.index = 17;
    scan.odom_T_robot = odom_T_world_ * jump;
    try {
      gmapping_->AddScan(scan);
      FAIL() << jump.x;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("scan 17"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::frontend
