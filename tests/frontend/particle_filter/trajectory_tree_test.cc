// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/trajectory_tree.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <vector>

#include "backend/counter_random.h"
#include "tests/frontend/particle_filter/same_map.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Index = TrajectoryTree::Index;
using Motion = TrajectoryTree::Motion;
using Vertex = TrajectoryTree::Vertex;

constexpr Index kNone = TrajectoryTree::kNone;

bool SameMotion(const Motion& a, const Motion& b) {
  return a.previous_T_robot == b.previous_T_robot && a.information == b.information &&
         a.matched == b.matched;
}

// Of everything but the indices of parents, which pruning may change.
bool SamePath(const std::vector<Vertex>& a, const std::vector<Vertex>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].world_T_robot == b[i].world_T_robot) || a[i].step != b[i].step) return false;
    if (!SameMotion(a[i].motion, b[i].motion)) return false;
  }
  return true;
}

TEST(TrajectoryTree, PathLeadsFromTheRootToTheLeaf) {
  TrajectoryTree tree;
  const Index root = tree.AddRoot({1, 0, 0});
  const Index left = tree.Append(root, {2, 0, 0}, {});
  const Index right = tree.Append(root, {3, 0, 0}, {});
  const Index leaf = tree.Append(left, {4, 0, 0}, {});
  EXPECT_EQ(PosesOf(tree.Path(leaf)), (std::vector<SE2>{{1, 0, 0}, {2, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(PosesOf(tree.Path(right)), (std::vector<SE2>{{1, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(PosesOf(tree.Path(root)), (std::vector<SE2>{{1, 0, 0}}));
  EXPECT_EQ(tree.LatestPoses(leaf, 2), (std::vector<SE2>{{4, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(tree.LatestPoses(right, 5), (std::vector<SE2>{{3, 0, 0}, {1, 0, 0}}));
  for (const TrajectoryTree::Index index : {root, right, leaf}) {
    EXPECT_EQ(tree.PosesOfPath(index), PosesOf(tree.Path(index)));
  }
}

TEST(TrajectoryTree, KeepsHowEachPoseWasReachedAndCountsItsAncestors) {
  const Motion first{{1, 2, 3}, 4.0 * Eigen::Matrix3d::Identity(), true};
  const Motion second{{5, 6, 7}, 8.0 * Eigen::Matrix3d::Identity(), false};
  TrajectoryTree tree;
  const Index root = tree.AddRoot({});
  const Index middle = tree.Append(root, {1, 0, 0}, first);
  const std::vector<Vertex> path = tree.Path(tree.Append(middle, {2, 0, 0}, second));
  ASSERT_EQ(path.size(), 3u);
  EXPECT_TRUE(SameMotion(path[1].motion, first));
  EXPECT_TRUE(SameMotion(path[2].motion, second));
  for (int step = 0; step < 3; ++step) EXPECT_EQ(path[step].step, step);
  EXPECT_EQ(path[0].parent, kNone);
  EXPECT_EQ(path[2].parent, middle);
}

TEST(TrajectoryTree, OnlyAKnownPoseCanBeContinuedOrSet) {
  TrajectoryTree tree;
  tree.AddRoot({});
  EXPECT_THROW(tree.Append(kNone, {}, {}), std::out_of_range);
  EXPECT_THROW(tree.Append(1, {}, {}), std::out_of_range);
  EXPECT_THROW(tree.SetPose(1, {}), std::out_of_range);
  EXPECT_EQ(tree.size(), 1u);
}

TEST(TrajectoryTree, PruningKeepsExactlyTheAncestorsAndNoPathChanges) {
  backend::CounterRandom random(1, 0);
  for (int trial = 0; trial < 50; ++trial) {
    TrajectoryTree tree;
    std::vector<Index> parents;
    for (int i = 0; i < 200; ++i) {  // now and then another root
      const Index parent = static_cast<Index>((i + 1) * random.Uniform()) - 1;
      parents.push_back(parent);
      const SE2 pose{random.Gaussian(), 0, 0};
      const Motion motion{{random.Gaussian(), 0, 0}, Eigen::Matrix3d::Identity(), i % 2 == 0};
      ASSERT_EQ(parent == kNone ? tree.AddRoot(pose) : tree.Append(parent, pose, motion), i);
    }
    std::vector<Index> leaves;
    std::set<Index> ancestors;
    std::vector<std::vector<Vertex>> paths;
    for (int k = 0; k < 5; ++k) {
      leaves.push_back(static_cast<Index>(200 * random.Uniform()));
      paths.push_back(tree.Path(leaves.back()));
      for (Index at = leaves.back(); at != kNone; at = parents[at]) ancestors.insert(at);
    }
    leaves.push_back(leaves.front());  // twins
    paths.push_back(paths.front());

    tree.Prune(&leaves);
    EXPECT_EQ(tree.size(), ancestors.size());
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      EXPECT_TRUE(SamePath(tree.Path(leaves[k]), paths[k]));
    }
    EXPECT_EQ(leaves.front(), leaves.back());
    for (Index i = 0; i < static_cast<Index>(tree.size()); ++i) {
      EXPECT_LT(tree.vertices()[i].parent, i);  // parents before children
    }

    const Index next = tree.Append(leaves[1], {7, 7, 7}, {});
    paths[1].push_back({{7, 7, 7}, {}, leaves[1], static_cast<int>(paths[1].size())});
    EXPECT_TRUE(SamePath(tree.Path(next), paths[1]));
  }
}

// A trunk of two poses, then two branches of two.
struct Forked {
  Forked() {
    root = tree.AddRoot({0, 0, 0.1});
    trunk = tree.Append(root, {1, 0, 0.2}, {{1, 0, 0}, Eigen::Matrix3d::Identity(), true});
    for (int k = 0; k < 2; ++k) {
      const SE2 pose{2, 0.1 * k, 0.3};
      const Index middle = tree.Append(trunk, pose, {{1, 1, 1}, Eigen::Matrix3d::Identity(), true});
      leaves.push_back(
          tree.Append(middle, pose * SE2{1, 0, 0}, {{2, 2, 2}, Eigen::Matrix3d::Zero(), false}));
    }
  }
  TrajectoryTree tree;
  Index root, trunk;
  std::vector<Index> leaves;
};

TEST(TrajectoryTree, SetPoseMovesThatPoseOnly) {
  Forked forked;
  const std::vector<Vertex> other = forked.tree.Path(forked.leaves[1]);
  std::vector<Vertex> path = forked.tree.Path(forked.leaves[0]);
  forked.tree.SetPose(forked.leaves[0], {9, 8, 7});
  path.back().world_T_robot = {9, 8, 7};
  EXPECT_TRUE(SamePath(forked.tree.Path(forked.leaves[0]), path));
  EXPECT_TRUE(SamePath(forked.tree.Path(forked.leaves[1]), other));
}

TEST(TrajectoryTree, CorrectionMovesEveryPoseOfEveryBranchOnceByItsStep) {
  Forked forked;
  PathCorrection correction;
  correction.before = PosesOf(forked.tree.Path(forked.leaves[0]));
  correction.before.pop_back();  // the last step moves with the one before
  for (std::size_t step = 0; step < correction.before.size(); ++step) {
    const double d = 0.1 * static_cast<double>(step + 1);
    correction.after.push_back(SE2{d, 2.0 * d, -d} * correction.before[step]);
  }
  const std::vector<Vertex> before = forked.tree.vertices();
  forked.tree.Correct(correction);
  ASSERT_EQ(forked.tree.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vertex& vertex = forked.tree.vertices()[i];
    const SE2 expected = correction.Apply(before[i].step, before[i].world_T_robot);
    EXPECT_TRUE(vertex.world_T_robot == expected) << i;
    EXPECT_FALSE(vertex.world_T_robot == before[i].world_T_robot) << i;
    // What was measured then stays measured.
    EXPECT_TRUE(SameMotion(vertex.motion, before[i].motion)) << i;
    EXPECT_EQ(vertex.parent, before[i].parent);
    EXPECT_EQ(vertex.step, before[i].step);
  }
}

TEST(TrajectoryTree, LongHistoriesDoNotExhaustTheStack) {
  constexpr int kLength = 300000;
  TrajectoryTree tree;
  Index leaf = tree.AddRoot({});
  for (int i = 1; i < kLength; ++i) leaf = tree.Append(leaf, {static_cast<double>(i), 0, 0}, {});
  tree.Append(leaf, {-1, 0, 0}, {});
  std::vector<Index> leaves = {leaf};
  tree.Prune(&leaves);
  EXPECT_EQ(tree.size(), std::size_t{kLength});
  const std::vector<Vertex> path = tree.Path(leaves[0]);
  ASSERT_EQ(path.size(), std::size_t{kLength});
  EXPECT_EQ(path.front().world_T_robot.x, 0.0);
  EXPECT_EQ(path.back().world_T_robot.x, kLength - 1.0);
  EXPECT_EQ(path.back().step, kLength - 1);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
