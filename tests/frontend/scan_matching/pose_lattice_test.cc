// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/pose_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <tuple>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

constexpr double kResolution = 0.05;

// A lattice on a field with narrow peaks, where bounds that are too low show.
struct RandomProblem {
  RandomProblem(std::uint32_t stream, int levels, int linear_steps, int angular_steps)
      : random(5, stream),
        points(RandomPoints(5)),
        field(
            MakeLikelihoodField({.resolution_m = kResolution, .sigma_m = 0.02}, RandomPoints(150))),
        pyramid(field, levels),
        lattice({{0.3, -0.2, 2.0}, kResolution, AngularStep(), linear_steps, angular_steps},
                &pyramid, points) {}

  std::vector<Eigen::Vector2d> RandomPoints(int count) {
    std::vector<Eigen::Vector2d> result(static_cast<std::size_t>(count));
    for (Eigen::Vector2d& point : result) {
      point = {3.0 * random.Uniform() - 1.5, 3.0 * random.Uniform() - 1.5};
    }
    return result;
  }

  double AngularStep() const {
    double farthest_m = 0.0;
    for (const Eigen::Vector2d& point : points) farthest_m = std::max(farthest_m, point.norm());
    return kResolution / farthest_m;
  }

  backend::CounterRandom random;
  std::vector<Eigen::Vector2d> points;
  ByteGrid field;
  FieldPyramid pyramid;
  PoseLattice lattice;
};

// Calls visit(pose) for all poses of the block; checks that no part exceeds the bound of the whole.
template <typename Visit>
void ForEachPose(const PoseLattice& lattice, const PoseBlock& block, const Visit& visit) {
  if (block.level == 0) return visit(block);
  lattice.ForEachPart(block, [&](const PoseBlock& part) {
    EXPECT_EQ(part.level, block.level - 1);
    EXPECT_LE(part.bound, block.bound);
    ForEachPose(lattice, part, visit);
  });
}

TEST(PoseLattice, NoPartOfABlockExceedsItsBoundAndPosesHaveTheSumOfTheField) {
  for (int levels = 1; levels <= 6; ++levels) {
    const RandomProblem problem(static_cast<std::uint32_t>(levels), levels, 9, 20);
    for (const PoseBlock& root : problem.lattice.Roots()) {
      ForEachPose(problem.lattice, root, [&](const PoseBlock& pose) {
        const SE2 map_T_scan = problem.lattice.Pose(pose);
        int sum = 0;
        for (const Eigen::Vector2d& point : problem.points) {
          const Eigen::Vector2d cells = map_T_scan * point / kResolution;
          sum += problem.field.value({map::FloorToCell(cells.x()), map::FloorToCell(cells.y())});
        }
        EXPECT_EQ(pose.bound, sum);
      });
    }
  }
}

TEST(PoseLattice, BlocksHoldEachPoseOnce) {
  for (const int linear_steps : {0, 1, 7, 8, 21}) {
    for (const int angular_steps : {0, 1, 6}) {
      const RandomProblem problem(0, 4, linear_steps, angular_steps);
      std::set<std::tuple<int, int, int>> seen;
      for (const PoseBlock& root : problem.lattice.Roots()) {
        ForEachPose(problem.lattice, root, [&](const PoseBlock& pose) {
          EXPECT_LE(std::abs(pose.x), linear_steps);
          EXPECT_LE(std::abs(pose.y), linear_steps);
          EXPECT_LE(std::abs(pose.angle), angular_steps);
          EXPECT_TRUE(seen.emplace(pose.angle, pose.y, pose.x).second);
        });
      }
      const int across = 2 * linear_steps + 1;
      EXPECT_EQ(static_cast<int>(seen.size()), across * across * (2 * angular_steps + 1));
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
