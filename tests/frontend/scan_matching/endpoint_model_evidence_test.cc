// SPDX-License-Identifier: BSD-3-Clause
// What a single beam says about a pose.
#include <gtest/gtest.h>

#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/endpoint_model.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

// A wall at x = 2 m, seen from the left from y = -1 m to 1 m.
class BeamAtAWall : public testing::Test {
 protected:
  BeamAtAWall() {
    for (int y = -20; y <= 20; ++y) {
      grid_.AddPasses({0, y}, {40, y});
      grid_.AddHit(40.5, y + 0.5);
    }
  }

  // Of a beam straight to the right, through the middle of a row of cells.
  Evidence Of(double range_m) { return At({}, range_m); }
  Evidence At(const SE2& world_T_robot, double range_m) {
    const ScanPoints points = {{range_m, 0.025, -1.0, 0.0}};
    return EndpointModel({}, &grid_, &points).Evaluate(world_T_robot);
  }
  double LogLikelihoodOf(double range_m) {
    const ScanPoints points = {{range_m, 0.025, -1.0, 0.0}};
    return EndpointModel({}, &grid_, &points).LogLikelihood({});
  }

  map::OccupancyGrid grid_{{}};
};

TEST_F(BeamAtAWall, ThatEndsThereSpeaksForThePose) {
  const Evidence evidence = Of(2.025);
  EXPECT_EQ(evidence.at_surface, 1.0);
  EXPECT_EQ(evidence.contradicted, 0.0);
  EXPECT_EQ(evidence.unknown, 0.0);
  EXPECT_NEAR(evidence.Fit(), 1.0, 1e-3);
  EXPECT_LT(Of(2.06).Fit(), evidence.Fit());
}

TEST_F(BeamAtAWall, ThatEndsInFreeSpaceSpeaksAgainstThePose) {
  for (const double range_m : {0.3, 1.0, 1.85}) {
    EXPECT_EQ(Of(range_m).contradicted, 1.0) << range_m;
    EXPECT_EQ(Of(range_m).Fit(), 0.0) << range_m;
  }
}

TEST_F(BeamAtAWall, ThatEndsBehindItSpeaksAgainstThePose) {
  for (const double range_m : {2.2, 2.4, 2.55}) {
    EXPECT_EQ(Of(range_m).contradicted, 1.0) << range_m;
  }
}

TEST_F(BeamAtAWall, ThatEndsInUnseenSpaceSaysNothing) {
  for (const double y : {1.3, -1.4, 5.0}) {
    const Evidence evidence = At({0, y, 0}, 2.0);
    EXPECT_EQ(evidence.unknown, 1.0) << y;
    EXPECT_EQ(evidence.known(), 0.0) << y;
    EXPECT_EQ(evidence.Fit(), 1.0) << y;
  }
}

TEST_F(BeamAtAWall, IsLikeliestThereAndLeastLikelyWhereItIsContradicted) {
  const double at_wall = LogLikelihoodOf(2.025), unseen = LogLikelihoodOf(5.0);
  EXPECT_GT(at_wall, unseen);
  EXPECT_GT(unseen, LogLikelihoodOf(1.0));
  EXPECT_EQ(LogLikelihoodOf(1.0), LogLikelihoodOf(2.4));
}

TEST_F(BeamAtAWall, PosesAreComparedByWhatIsKnownOnly) {
  // The wall goes on where nobody has looked: half of the beams are as good as all of them.
  ScanPoints points;
  for (int y = -20; y <= 60; ++y) points.push_back({2.025, 0.05 * y + 0.025, -1.0, 0.0});
  EndpointModel model({}, &grid_, &points);
  const double whole = EndpointModel({}, &grid_, &points).Evaluate({}).Fit();
  points.resize(41);
  const double seen = EndpointModel({}, &grid_, &points).Evaluate({}).Fit();
  EXPECT_NEAR(whole, seen, 0.03);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
