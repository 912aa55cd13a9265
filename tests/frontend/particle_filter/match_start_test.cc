// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/match_start.h"

#include <gtest/gtest.h>

#include "tests/frontend/room_map.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::CounterRandom;
using backend::SE2;

class MatchStartInARoom : public testing::Test {
 protected:
  SE2 Choose(const MatchStart::Options& options, CounterRandom* random) {
    return MakeMatchStart(options, motion_model_)->Choose(previous_, control_, &model_, random);
  }

  const map::OccupancyGrid grid_ = synthetic::RoomMap();
  const SE2 truth_{0.4, -0.3, 0.8};
  const scan_matching::ScanPoints points_ =
      scan_matching::MakeScanPoints(synthetic::Scan(synthetic::Room(), truth_));
  scan_matching::EndpointModel model_{{}, &grid_, &points_};
  const SE2 previous_ = truth_ * SE2{-0.5, 0, 0};
  const Control control_{.motion = {0.55, 0.05, 0.1}};  // slipped
  const MotionModel motion_model_{{.linear_per_linear = 0.1, .angular_per_linear = 0.2}};
  CounterRandom random_{1, 0};
};

TEST_F(MatchStartInARoom, PredictionIsThatOfTheOdometry) {
  EXPECT_TRUE(Choose({}, &random_) == previous_ * control_.motion);
}

TEST_F(MatchStartInARoom, TheBestOfManyGuessesFitsBetter) {
  const SE2 best = Choose({.guesses = 200}, &random_);
  EXPECT_GT(model_.Score(best), model_.Score(previous_ * control_.motion) + 0.1);
  EXPECT_LT(Between(best, truth_).translation().norm(), 0.05);
}

TEST_F(MatchStartInARoom, ADrawIsThatOfTheMotionModelHoweverItFits) {
  CounterRandom same(1, 0);
  const SE2 draw = Choose({.kind = MatchStart::Kind::kDraw, .guesses = 200}, &random_);
  EXPECT_TRUE(draw == motion_model_.Sample(previous_, control_, &same));
}

TEST_F(MatchStartInARoom, AFailedMatchDrawsAfreshUnlessItHasStartedAtADraw) {
  const SE2 start{1, 2, 3};
  const auto draw_instead = [&](MatchStart::Kind kind) {
    return MakeMatchStart({.kind = kind}, motion_model_)
        ->SampleInstead(start, previous_, control_, &random_);
  };
  CounterRandom same(1, 0);
  EXPECT_TRUE(draw_instead(MatchStart::Kind::kPrediction) ==
              motion_model_.Sample(previous_, control_, &same));
  EXPECT_TRUE(draw_instead(MatchStart::Kind::kDraw) == start);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
