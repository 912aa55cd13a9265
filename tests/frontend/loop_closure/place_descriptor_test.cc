// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/place_descriptor.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "backend/se2.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

// What a laser that looks all round sees on the Ring, in its frame.
std::vector<Eigen::Vector2d> SeenAt(double path_length_m, double turn_rad) {
  const sensor::LaserScan scan =
      synthetic::Scan(synthetic::Ring(), synthetic::OnRing(path_length_m) * SE2{0, 0, turn_rad},
                      {.beams = 721, .field_of_view_rad = 2.0 * std::numbers::pi});
  std::vector<Eigen::Vector2d> points;
  for (const sensor::Beam& beam : scan.beams) {
    points.emplace_back(beam.range_m * std::cos(beam.angle_rad),
                        beam.range_m * std::sin(beam.angle_rad));
  }
  return points;
}

TEST(ComputeDescriptor, DoesNotDependOnTheHeading) {
  const PlaceDescriptor place = ComputeDescriptor(SeenAt(5.0, 0.0));
  EXPECT_NEAR(place.norm(), 1.0, 1e-5);
  for (const double turn_rad : {0.3, 1.5, 3.1}) {
    EXPECT_LT(Dissimilarity(place, ComputeDescriptor(SeenAt(5.0, turn_rad))), 0.02) << turn_rad;
  }
}

TEST(ComputeDescriptor, TellsPlacesApart) {
  const PlaceDescriptor place = ComputeDescriptor(SeenAt(2.0, 0.0));
  const double same = Dissimilarity(place, ComputeDescriptor(SeenAt(2.3, 2.0)));
  for (const double path_length_m : {8.0, 15.0, 21.0, 32.0}) {
    EXPECT_GT(Dissimilarity(place, ComputeDescriptor(SeenAt(path_length_m, 0.0))), 1.5 * same)
        << path_length_m;
  }
}

TEST(ComputeDescriptor, LeavesOutWhatIsFarAway) {
  EXPECT_EQ(ComputeDescriptor({{kDescriptorRadius_m, 0.0}, {0.0, -100.0}}).norm(), 0.0);
}

TEST(ComputeDescriptor, OfNothingIsZeroAndLikeNothing) {
  const PlaceDescriptor nothing = ComputeDescriptor({});
  EXPECT_EQ(nothing.norm(), 0.0);
  EXPECT_EQ(Dissimilarity(nothing, ComputeDescriptor({{1.0, 2.0}})), 1.0);
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
