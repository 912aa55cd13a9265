// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map_session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/frontend/localization/known_hall.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;
using loop_closure::ClosureRecord;

class MapSessionTest : public testing::Test {
 protected:
  static MapSession::Known Known() {
    MapSession::Known known({});
    known.map = synthetic::MapOf(synthetic::Hall());
    for (double way_m = 0.0; way_m < 48.0; way_m += 1.0) {
      known.nodes.push_back(static_cast<int>(known.world_T_nodes.size()));
      known.world_T_nodes.push_back(synthetic::OnRing(way_m));
    }
    return known;
  }

  // Drives until the robot is found.
  static std::optional<ClosureRecord> Drive(double from_m, double to_m, MapSession* session) {
    const auto scans = synthetic::Driven(synthetic::Hall(), from_m, to_m);
    const SE2 world_T_node = scans.front().odom_T_robot;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      const SE2 motion = k > 0 ? Between(scans[k - 1].odom_T_robot, scans[k].odom_T_robot) : SE2{};
      const auto closure =
          session->AddScan(scans[k], motion, 100, Between(scans[k].odom_T_robot, world_T_node))
              .closure;
      if (closure) return closure;
    }
    return std::nullopt;
  }
};

TEST_F(MapSessionTest, TheClosureLeadsFromTheNearestOldNodeToTheNewestOne) {
  MapSession session(MapSession::Use::kMapOn, Known());
  const std::optional<ClosureRecord> closure = Drive(20.3, 22.0, &session);
  ASSERT_TRUE(closure);
  EXPECT_EQ(closure->old_node, 20);
  EXPECT_EQ(closure->node, 100);
  const SE2 truth = Between(synthetic::OnRing(20.0), synthetic::OnRing(20.3));
  const SE2 off = Between(truth, closure->old_T_node);
  EXPECT_LT(off.translation().norm(), 0.05);
  EXPECT_LT(std::abs(off.theta), 0.02);
  EXPECT_GT(closure->information(0, 0), 100.0);
  EXPECT_FALSE(session.searches());
  ASSERT_EQ(session.found().size(), 1u);
  EXPECT_LT(session.found()[0].after_s, 1.7);
}

TEST_F(MapSessionTest, NodesThatAreNoPartOfTheMapAreNotJoinedWith) {
  MapSession::Known known = Known();
  std::erase_if(known.nodes, [](int node) { return node % 2 == 0; });
  MapSession session(MapSession::Use::kMapOn, known);
  const std::optional<ClosureRecord> closure = Drive(20.1, 22.0, &session);
  ASSERT_TRUE(closure);
  EXPECT_EQ(closure->old_node % 2, 1);
}

TEST_F(MapSessionTest, ARobotThatWasFoundIsNotLookedForUntilItIsLost) {
  MapSession session(MapSession::Use::kLocalize, Known());
  ASSERT_TRUE(Drive(5.0, 7.0, &session));
  EXPECT_FALSE(Drive(7.0, 9.0, &session));
  session.BeginPiece();
  EXPECT_TRUE(session.searches());
  ASSERT_TRUE(Drive(30.0, 32.0, &session));
  EXPECT_EQ(session.found().size(), 2u);
  EXPECT_TRUE(session.is_fixed());
}

}  // namespace
}  // namespace gmapping_spa::frontend
