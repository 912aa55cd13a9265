#include "frontend/particle_filter/trajectory_tree.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Index = TrajectoryTree::Index;

constexpr Index kNone = TrajectoryTree::kNone;

TEST(TrajectoryTree, PathLeadsFromTheRootToTheLeaf) {
  TrajectoryTree tree;
  const Index root = tree.Append(kNone, {1, 0, 0});
  const Index left = tree.Append(root, {2, 0, 0});
  const Index right = tree.Append(root, {3, 0, 0});
  const Index leaf = tree.Append(left, {4, 0, 0});
  EXPECT_EQ(tree.Path(leaf), (std::vector<SE2>{{1, 0, 0}, {2, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(tree.Path(right), (std::vector<SE2>{{1, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(tree.Path(root), (std::vector<SE2>{{1, 0, 0}}));
}

TEST(TrajectoryTree, PruningKeepsExactlyTheAncestorsAndNoPathChanges) {
  backend::CounterRandom random(1, 0);
  for (int trial = 0; trial < 50; ++trial) {
    TrajectoryTree tree;
    std::vector<Index> parents;
    for (int i = 0; i < 200; ++i) {  // now and then another root
      const Index parent = static_cast<Index>((i + 1) * random.Uniform()) - 1;
      parents.push_back(parent);
      ASSERT_EQ(tree.Append(parent, {random.Gaussian(), 0, 0}), i);
    }
    std::vector<Index> leaves;
    std::set<Index> ancestors;
    std::vector<std::vector<SE2>> paths;
    for (int k = 0; k < 5; ++k) {
      leaves.push_back(static_cast<Index>(200 * random.Uniform()));
      paths.push_back(tree.Path(leaves.back()));
      for (Index at = leaves.back(); at != kNone; at = parents[at]) ancestors.insert(at);
    }
    leaves.push_back(leaves.front());  // twins
    paths.push_back(paths.front());

    tree.Prune(&leaves);
    EXPECT_EQ(tree.size(), ancestors.size());
    for (std::size_t k = 0; k < leaves.size(); ++k) EXPECT_EQ(tree.Path(leaves[k]), paths[k]);
    EXPECT_EQ(leaves.front(), leaves.back());

    const Index next = tree.Append(leaves[1], {7, 7, 7});
    paths[1].push_back({7, 7, 7});
    EXPECT_EQ(tree.Path(next), paths[1]);
  }
}

TEST(TrajectoryTree, LongHistoriesDoNotExhaustTheStack) {
  constexpr int kLength = 1000000;
  TrajectoryTree tree;
  Index leaf = kNone;
  for (int i = 0; i < kLength; ++i) leaf = tree.Append(leaf, {static_cast<double>(i), 0, 0});
  tree.Append(leaf, {-1, 0, 0});
  std::vector<Index> leaves = {leaf};
  tree.Prune(&leaves);
  EXPECT_EQ(tree.size(), std::size_t{kLength});
  const std::vector<SE2> path = tree.Path(leaves[0]);
  ASSERT_EQ(path.size(), std::size_t{kLength});
  EXPECT_EQ(path.front().x, 0.0);
  EXPECT_EQ(path.back().x, kLength - 1.0);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
