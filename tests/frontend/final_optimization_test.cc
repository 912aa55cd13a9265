// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/final_optimization.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::SE2;

constexpr int kNodeEvery = 4;  // scans

// A drive with perfect odometry whose nodes' poses are given, as a run of SLAM would have left it.
class FinalOptimizationTest : public testing::Test {
 protected:
  // `order[k]` is the position in the input of the k-th scan in the order of time.
  void Drive(const std::vector<SE2>& poses, const synthetic::Walls& walls,
             const std::vector<int>& order = {}) {
    truth_ = poses;
    std::vector<sensor::LaserScan> scans = synthetic::ScansAt(poses, walls);
    for (std::size_t k = 0; k < scans.size(); ++k) {
      if (!order.empty()) scans[k].index = order[k];
      const bool is_node = k % kNodeEvery == 0;
      if (is_node) {
        const auto id = static_cast<std::int64_t>(node_scans_.size());
        node_scans_.push_back(static_cast<int>(k));
        path_.nodes.push_back({.id = id, .stamp_s = scans[k].stamp_s, .world_T_node = poses[k]});
        if (id > 0) {
          backend::Edge edge;
          edge.i = id - 1;
          edge.j = id;
          edge.i_T_j = Between(poses[k - kNodeEvery], poses[k]);
          path_.edges.push_back(edge);
        }
      }
      archive_.Add(scans[k], Eigen::Vector3d::Zero());
      scan_poses_.Add(scans[k], poses[k], 1.0, is_node);
    }
  }

  // Rounds in the room, near enough to its walls for a good map.
  void DriveInTheRoom() {
    std::vector<SE2> poses;
    for (int k = 0; k < 80; ++k) {
      poses.push_back({1.3 * std::cos(0.1 * k), 1.1 * std::sin(0.1 * k), 0.1 * k + 1.6});
    }
    Drive(poses, synthetic::Room());
  }

  // Moves every fifth node, so that most scans still say where the walls are.
  void Disturb(double m, double rad) {
    for (std::size_t k = 2; k < path_.nodes.size(); k += 5) {
      SE2& pose = path_.nodes[k].world_T_node;
      const double sign = k % 2 == 0 ? 1.0 : -1.0;
      pose = {pose.x + sign * m, pose.y - sign * m, pose.theta + sign * rad};
    }
  }

  static FinalOptimization::Options Refine(int rounds) {
    FinalOptimization::Options options;
    options.refine = rounds;
    return options;
  }

  SlamResult Finish(const FinalOptimization::Options& options,
                    loop_closure::LoopCloser* closer = nullptr) {
    FinalOptimization final_optimization(options, {.scans = &archive_,
                                                   .node_scans = &node_scans_,
                                                   .scan_poses = &scan_poses_,
                                                   .grid = {},
                                                   .insertion = {},
                                                   .loop_closer = closer,
                                                   .optimize = optimize_});
    return final_optimization.Finish(path_);
  }

  static double LargestError(const backend::Trajectory& trajectory, const std::vector<SE2>& truth) {
    double largest_m = 0.0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const SE2 off = Between(truth[k], trajectory.at(k).world_T_robot);
      largest_m = std::max(largest_m, off.translation().norm());
    }
    return largest_m;
  }

  std::vector<SE2> truth_;
  sensor::ScanArchive archive_;
  std::vector<int> node_scans_;
  ScanPoses scan_poses_;
  PoseGraph path_;
  std::vector<PoseGraph> asked_;  // what the back end got
  std::function<std::optional<PoseGraph>(const PoseGraph&)> optimize_ =
      [this](const PoseGraph& graph) -> std::optional<PoseGraph> {
    asked_.push_back(graph);
    return std::nullopt;
  };
};

TEST_F(FinalOptimizationTest, PosesStayWhenTheBackEndFails) {
  DriveInTheRoom();
  Disturb(0.05, 0.01);
  const SlamResult estimate = Finish(Refine(0));
  ASSERT_EQ(estimate.graph.nodes.size(), path_.nodes.size());
  for (std::size_t k = 0; k < path_.nodes.size(); ++k) {
    const SE2& pose = path_.nodes[k].world_T_node;
    EXPECT_LT(Log(Between(pose, estimate.graph.nodes[k].world_T_node)).norm(), 1e-12);
    EXPECT_LT(Log(Between(pose, estimate.trajectory[kNodeEvery * k].world_T_robot)).norm(), 1e-12);
  }
  EXPECT_EQ(estimate.graph.edges.size(), path_.edges.size());
  EXPECT_EQ(asked_.size(), 1u);
}

TEST_F(FinalOptimizationTest, PosesAreThoseOfTheBackEnd) {
  DriveInTheRoom();
  Disturb(0.5, 0.1);
  optimize_ = [this](const PoseGraph& graph) -> std::optional<PoseGraph> {
    PoseGraph optimized = graph;
    for (std::size_t k = 0; k < optimized.nodes.size(); ++k) {
      optimized.nodes[k].world_T_node = truth_[kNodeEvery * k];
    }
    return optimized;
  };
  // The scans after the last node follow the odometry, which is right.
  EXPECT_LT(LargestError(Finish(Refine(0)).trajectory, truth_), 1e-9);
}

TEST_F(FinalOptimizationTest, RefiningBringsDisturbedScansBack) {
  DriveInTheRoom();
  Disturb(0.04, 0.01);
  ASSERT_GT(LargestError(Finish(Refine(0)).trajectory, truth_), 0.05);
  const SlamResult estimate = Finish(Refine(1));
  EXPECT_LT(LargestError(estimate.trajectory, truth_), 0.02);
  for (std::size_t k = 0; k < estimate.graph.nodes.size(); ++k) {
    EXPECT_EQ(estimate.graph.nodes[k].world_T_node,
              estimate.trajectory[kNodeEvery * k].world_T_robot);
  }
}

TEST_F(FinalOptimizationTest, FurtherRoundsGoOnFromRefinedPosesWhenTheBackEndFails) {
  DriveInTheRoom();
  Disturb(0.05, 0.01);
  const double once_m = LargestError(Finish(Refine(1)).trajectory, truth_);
  const double thrice_m = LargestError(Finish(Refine(3)).trajectory, truth_);
  EXPECT_LT(thrice_m, once_m);
}

TEST_F(FinalOptimizationTest, ScansThatWereLeftOutOfTheInputLeaveNoHoles) {
  std::vector<SE2> poses;
  std::vector<int> order;
  for (int k = 0; k < 40; ++k) {
    poses.push_back({1.3 * std::cos(0.1 * k), 1.1 * std::sin(0.1 * k), 0.1 * k + 1.6});
    order.push_back(1000 + 7 * k);
  }
  Drive(poses, synthetic::Room(), order);
  const SlamResult estimate = Finish(Refine(1));
  ASSERT_EQ(estimate.trajectory.size(), poses.size());
  EXPECT_LT(LargestError(estimate.trajectory, truth_), 0.02);
}

TEST_F(FinalOptimizationTest, RefiningMovesNoScanFartherThanItMay) {
  DriveInTheRoom();
  Disturb(0.04, 0.01);
  const SlamResult as_it_was = Finish(Refine(0));
  std::vector<FinalOptimization::Options> strict(3, Refine(1));
  strict[0].max_shift_m = 1e-9;
  strict[1].max_shift_rad = 1e-9;
  strict[2].min_inliers = 1.01;
  for (const FinalOptimization::Options& options : strict) {
    const SlamResult estimate = Finish(options);
    for (std::size_t k = 0; k < truth_.size(); ++k) {
      EXPECT_EQ(estimate.trajectory[k].world_T_robot, as_it_was.trajectory[k].world_T_robot);
    }
  }
}

TEST_F(FinalOptimizationTest, RefiningAlternatesWithTheBackEnd) {
  DriveInTheRoom();
  Disturb(0.04, 0.01);
  FinalOptimization::Options options = Refine(2);
  options.refined_sigma_m = 0.1;
  options.refined_sigma_rad = 0.01;
  Finish(options);
  ASSERT_EQ(asked_.size(), 2u);
  // The second time it is told what the refined scans say.
  for (const backend::Edge& edge : asked_[1].edges) {
    const SE2 truth = Between(truth_[kNodeEvery * edge.i], truth_[kNodeEvery * edge.j]);
    EXPECT_LT(Between(truth, edge.i_T_j).translation().norm(), 0.02);
    EXPECT_TRUE(edge.information.isApprox(
        Eigen::Matrix3d(Eigen::Vector3d(100, 100, 10000).asDiagonal()), 1e-9));
  }
}

TEST_F(FinalOptimizationTest, TrajectoryIsInTheOrderOfTheInput) {
  std::vector<SE2> poses;
  std::vector<int> order;
  for (int k = 0; k < 21; ++k) {
    poses.push_back({0.05 * k, 0.02 * k, 0.01 * k});
    order.push_back((8 * k) % 21);
  }
  Drive(poses, synthetic::Room(), order);
  for (const int refine : {0, 1}) {
    const SlamResult estimate = Finish(Refine(refine));
    ASSERT_EQ(estimate.trajectory.size(), 21u);
    for (int k = 0; k < 21; ++k) {
      const backend::StampedPose& pose = estimate.trajectory[order[k]];
      EXPECT_DOUBLE_EQ(pose.stamp_s, 0.1 * k);
      EXPECT_LT(Between(poses[k], pose.world_T_robot).translation().norm(), 0.01);
    }
  }
}

TEST_F(FinalOptimizationTest, MapIsMadeOfAllScansAtTheFinalPoses) {
  DriveInTheRoom();
  Disturb(0.04, 0.01);
  const SlamResult estimate = Finish({});
  map::OccupancyGrid expected({});
  for (int k = 0; k < archive_.size(); ++k) {
    map::InsertScan(archive_.Get(k), estimate.trajectory[k].world_T_robot, {}, &expected);
  }
  int known = 0;
  for (int x = -160; x < 160; ++x) {
    for (int y = -160; y < 160; ++y) {
      ASSERT_EQ(estimate.map.cell({x, y}).visits, expected.cell({x, y}).visits) << x << ' ' << y;
      ASSERT_EQ(estimate.map.cell({x, y}).hits, expected.cell({x, y}).hits) << x << ' ' << y;
      known += expected.cell({x, y}).visits > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(known, 10000);
}

TEST_F(FinalOptimizationTest, ClosesLoopsEverywhereUntilNothingIsFound) {
  Drive(synthetic::DriveOnRing(0, 60, 0.25), synthetic::Ring());
  loop_closure::LoopCloser closer({});
  FinalOptimization::Options options = Refine(0);
  options.closing_rounds = 5;
  const SlamResult estimate = Finish(options, &closer);
  EXPECT_GE(closer.closures().size(), 2u);
  // Once before, and once after the round that found something; the next one finds nothing.
  EXPECT_EQ(asked_.size(), 2u);
  EXPECT_EQ(asked_[0].edges.size(), path_.edges.size());
  EXPECT_EQ(asked_[1].edges.size(), path_.edges.size() + closer.closures().size());
  EXPECT_EQ(estimate.graph.edges.size(), path_.edges.size() + closer.closures().size());
}

TEST_F(FinalOptimizationTest, LetsGoOfAClosureThatTheBackEndContradicts) {
  Drive(synthetic::DriveOnRing(0, 60, 0.25), synthetic::Ring());
  loop_closure::LoopCloser closer({});
  // A back end that holds a node 3 m off where its closures say.
  std::int64_t moved = -1;
  optimize_ = [&](const PoseGraph& graph) -> std::optional<PoseGraph> {
    asked_.push_back(graph);
    PoseGraph optimized = graph;
    if (moved < 0 && graph.edges.size() > path_.edges.size()) {
      moved = graph.edges.back().j;
      optimized.nodes.at(moved).world_T_node.y += 3.0;
    }
    return optimized;
  };
  FinalOptimization::Options options = Refine(0);
  options.closing_rounds = 1;
  const SlamResult estimate = Finish(options, &closer);
  ASSERT_GE(moved, 0);
  ASSERT_FALSE(closer.closures().empty());
  for (const backend::Edge& closure : closer.closures()) EXPECT_NE(closure.j, moved);
  EXPECT_LT(asked_.back().edges.size(), asked_[asked_.size() - 2].edges.size());
  EXPECT_EQ(estimate.graph.edges.size(), path_.edges.size() + closer.closures().size());
}

TEST_F(FinalOptimizationTest, ABackEndThatMovesNothingContradictsNothing) {
  Drive(synthetic::DriveOnRing(0, 60, 0.25), synthetic::Ring());
  for (backend::Node& node : path_.nodes) {
    if (node.id >= 45) node.world_T_node.x += 0.6;  // closures are far off their estimate
  }
  loop_closure::LoopCloser::Options closing;
  closing.max_squared_error = 1e-3;
  loop_closure::LoopCloser closer(closing);
  Finish(Refine(0), &closer);
  EXPECT_GE(closer.closures().size(), 2u);
}

TEST_F(FinalOptimizationTest, NoClosingRoundsFindNothing) {
  Drive(synthetic::DriveOnRing(0, 60, 0.25), synthetic::Ring());
  loop_closure::LoopCloser closer({});
  FinalOptimization::Options options = Refine(0);
  options.closing_rounds = 0;
  Finish(options, &closer);
  EXPECT_TRUE(closer.records().empty());
}

}  // namespace
}  // namespace gmapping_spa::frontend
