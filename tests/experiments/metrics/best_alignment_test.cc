// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/best_alignment.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/experiments/metrics/hand_made_building.h"

namespace gmapping_spa::metrics {
namespace {

using backend::SE2;

void ExpectNear(const SE2& a, const SE2& b, double distance_m, double angle_rad) {
  const SE2 between = Inverse(a) * b;
  EXPECT_LT(between.translation().norm(), distance_m);
  EXPECT_LT(std::abs(between.theta), angle_rad);
}

TEST(BestAlignment, OfTheTruthIsNotMoved) {
  EXPECT_EQ(FindBestAlignment(Building(), Building(), {SE2()}), SE2());
  ExpectNear(FindBestAlignment(Building(), Building(0.025), {SE2()}), SE2(), 0.03, 0.005);
}

TEST(BestAlignment, IsFoundFromNearby) {
  for (const SE2& away : {SE2{0.3, -0.2, 0.0}, SE2{0.0, 0.1, 0.04}, SE2{-0.15, 0.15, -0.05}}) {
    ExpectNear(FindBestAlignment(Building(), Building(), {away}), SE2(), 0.1, 0.02);
  }
}

TEST(BestAlignment, IsThatOfMostOfTheMapAndNotOfAllOfIt) {
  // The right quarter of the building is drawn 0.5 m too far up.
  const Box right{7.5, 0.5, 9.5, 7.5};
  const map::TrinaryMap map =
      Without(DrawnTwice(Building(), right, 0.0, 0.5), {7.5, 0.5, 8.9, 1.2});
  ExpectNear(FindBestAlignment(Building(), map, {SE2{0.0, -0.1, 0.0}}), SE2(), 0.03, 0.005);
}

TEST(BestAlignment, IsThatOfTheBestCandidate) {
  ExpectNear(FindBestAlignment(Building(), Building(), {SE2{3.0, 2.0, 1.0}, SE2{0.1, 0.1, 0.0}}),
             SE2(), 0.1, 0.02);
}

TEST(BestAlignment, OfAnEmptyMapIsTheFirstCandidate) {
  const SE2 first{1.0, 2.0, 0.3};
  EXPECT_EQ(FindBestAlignment(Building(), UnknownMap(5, 5), {first, SE2()}), first);
  EXPECT_THROW(FindBestAlignment(Building(), Building(), {}), std::invalid_argument);
}

}  // namespace
}  // namespace gmapping_spa::metrics
