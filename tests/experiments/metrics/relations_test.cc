// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/relations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "experiments/apps/input_file.h"
#include "tests/message_of.h"
#include "tests/real_data.h"

namespace gmapping_spa::metrics::relations_test {
namespace {

using backend::SE2;
using backend::Trajectory;

constexpr double kDegree = std::numbers::pi / 180.0;

std::vector<Relation> Read(const std::string& text) {
  std::istringstream in(text);
  return ReadRelations(in, "r.relations");
}

TEST(ReadRelations, TakesThePlanarPart) {
  const auto relations = Read("# comment\n976052905.167303 976052911.885496 1 2 3 0.1 0.2 -1.5\n");
  ASSERT_EQ(relations.size(), 1u);
  EXPECT_EQ(relations[0].stamp_i_s, 976052905.167303);
  EXPECT_EQ(relations[0].stamp_j_s, 976052911.885496);
  EXPECT_EQ(relations[0].i_T_j, (SE2{1, 2, -1.5}));
}

TEST(ReadRelations, ErrorsNameTheLine) {
  EXPECT_EQ(MessageOf([] { Read("1 2 0 0 0 0 0 0\n1 2 3\n"); }),
            "r.relations:2: expected 8 columns (t1 t2 x y z roll pitch yaw), found 3");
}

TEST(EvaluateRelations, ThreeRelationsByHand) {
  // The estimate drives 1 m ahead, turns left by 90 degrees, drives 1 m ahead.
  const double left = std::numbers::pi / 2;
  const Trajectory trajectory = {
      {0, {0, 0, 0}}, {1, {1, 0, 0}}, {2, {1, 0, left}}, {3, {1, 1, left}}};
  const std::vector<Relation> relations = {
      {0, 1, {0.9, 0, 0}},                      // 0.1 m off
      {1, 2, {0, 0, left - kDegree}},           // 1 degree off
      {0, 3, {0.7, 0.6, left + 4 * kDegree}}};  // 0.3, 0.4 m and 4 degrees off
  const RelationsSummary summary = EvaluateRelations(relations, trajectory, {.max_gap_s = 0});
  EXPECT_EQ(summary.used, 3);
  EXPECT_EQ(summary.not_associated, 0);
  EXPECT_NEAR(summary.translation_m.mean, 0.2, 1e-12);
  EXPECT_NEAR(summary.translation_m.median, 0.1, 1e-12);
  EXPECT_NEAR(summary.translation_m.max, 0.5, 1e-12);
  EXPECT_NEAR(summary.translation_m.std, std::sqrt((0.01 + 0.04 + 0.09) / 3), 1e-12);
  EXPECT_NEAR(summary.rotation_deg.mean, 5.0 / 3.0, 1e-12);
  EXPECT_NEAR(summary.rotation_deg.median, 1.0, 1e-12);
  EXPECT_NEAR(summary.rotation_deg.max, 4.0, 1e-12);
}

TEST(EvaluateRelations, AnglesAreComparedAcrossTheHalfTurn) {
  const Trajectory trajectory = {{0, {0, 0, 0}}, {1, {0, 0, 179 * kDegree}}};
  const auto summary = EvaluateRelations({{0, 1, {0, 0, -179 * kDegree}}}, trajectory, {});
  EXPECT_NEAR(summary.rotation_deg.mean, 2.0, 1e-9);
}

TEST(EvaluateRelations, TheWorldFrameAndTheOrderDoNotMatter) {
  const std::vector<Relation> relations = {{0, 1, {0.9, 0.1, 0.2}}, {1, 2, {1, 0, -0.3}}};
  const Trajectory trajectory = {{0, {0, 0, 0.1}}, {1, {1, 0.2, 0}}, {2, {2, 0, -0.2}}};
  const SE2 other_T_world = {100, -50, 2.5};
  Trajectory moved;
  for (const std::size_t k : {1, 2, 0}) {
    moved.push_back({trajectory[k].stamp_s, other_T_world * trajectory[k].world_T_robot});
  }
  const auto a = EvaluateRelations(relations, trajectory, {});
  const auto b = EvaluateRelations(relations, moved, {});
  EXPECT_GT(a.translation_m.mean, 0.01);
  EXPECT_NEAR(a.translation_m.mean, b.translation_m.mean, 1e-12);
  EXPECT_NEAR(a.rotation_deg.mean, b.rotation_deg.mean, 1e-9);
}

TEST(EvaluateRelations, CountsWhatHasNoStampNearEnough) {
  const Trajectory trajectory = {{0, {0, 0, 0}}, {1, {1, 0, 0}}, {5, {5, 0, 0}}};
  const std::vector<Relation> relations = {
      {0, 1, {1, 0, 0}}, {0, 3, {3, 0, 0}}, {3, 5, {2, 0, 0}}, {0.1, 4.95, {4.85, 0, 0}}};
  const auto summary = EvaluateRelations(relations, trajectory, {.max_gap_s = 0.1});
  EXPECT_EQ(summary.used, 2);
  EXPECT_EQ(summary.not_associated, 2);
  EXPECT_NEAR(summary.translation_m.max, 0.0, 1e-12);
}

TEST(EvaluateRelations, NothingToUseIsAnError) {
  EXPECT_THROW(EvaluateRelations({{0, 1, {}}}, {}, {}), std::runtime_error);
  EXPECT_THROW(EvaluateRelations({}, {{0, {}}}, {}), std::runtime_error);
}

// The odometry at each FLASER line, with the ipc time stamp: the fields after the ranges are the
// pose of the laser, the pose of the robot, and that stamp.
Trajectory RawOdometry(const std::string& path) {
  const auto in = apps::OpenInput(path);
  Trajectory trajectory;
  std::string line;
  while (std::getline(*in, line)) {
    std::istringstream fields(line);
    std::string record;
    int ranges = 0;
    fields >> record >> ranges;
    if (record != "FLASER") continue;
    double skipped = 0.0;
    for (int k = 0; k < ranges + 3; ++k) fields >> skipped;
    backend::StampedPose pose;
    fields >> pose.world_T_robot.x >> pose.world_T_robot.y >> pose.world_T_robot.theta;
    fields >> pose.stamp_s;
    EXPECT_TRUE(fields) << line;
    trajectory.push_back(pose);
  }
  return trajectory;
}

struct Known {
  std::string name;
  int relations;
  double translation_m, rotation_deg;
  friend void PrintTo(const Known& known, std::ostream* out) { *out << known.name; }
};

class RawOdometryTest : public ::testing::TestWithParam<Known> {};

TEST_P(RawOdometryTest, ScoresAsKnown) {
  const Known& known = GetParam();
  const auto relations_path = RealDataPath("relations/" + known.name + ".relations.gz");
  const auto log_path = RealDataPath("carmen/" + known.name + ".clf.gz");
  if (!relations_path || !log_path) {
    GTEST_SKIP() << "needs the public data sets: set GMAPPING_SPA_DATA to their folder";
  }
  const auto relations = ReadRelations(*apps::OpenInput(*relations_path), *relations_path);
  const auto summary = EvaluateRelations(relations, RawOdometry(*log_path), {.max_gap_s = 0});
  EXPECT_EQ(summary.used, known.relations);
  EXPECT_EQ(summary.not_associated, 0);
  EXPECT_NEAR(summary.translation_m.mean, known.translation_m, 0.0005);
  EXPECT_NEAR(summary.rotation_deg.mean, known.rotation_deg, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Benchmark, RawOdometryTest,
                         ::testing::Values(Known{"intel", 2984, 7.370, 39.2},
                                           Known{"fr079", 1685, 6.504, 30.3},
                                           Known{"aces", 1279, 0.549, 2.33}),
                         [](const auto& known) { return known.param.name; });

}  // namespace
}  // namespace gmapping_spa::metrics::relations_test
