// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/match_start.h"

#include <glog/logging.h>

namespace gmapping_spa::particle_filter {
namespace {

using backend::CounterRandom;
using backend::SE2;

class StartAtPrediction : public MatchStart {
 public:
  StartAtPrediction(int guesses, const MotionModel& motion_model)
      : guesses_(guesses), motion_model_(motion_model) {
    CHECK_GE(guesses, 0);
  }

  SE2 Choose(const SE2& world_T_previous, const Control& control,
             scan_matching::EndpointModel* model, CounterRandom* random) const override {
    SE2 best = world_T_previous * control.motion;
    double best_score = model->Score(best);
    for (int k = 0; k < guesses_; ++k) {
      const SE2 guess = motion_model_.Sample(world_T_previous, control, random);
      const double score = model->Score(guess, best_score);
      if (score > best_score) {
        best = guess;
        best_score = score;
      }
    }
    return best;
  }

  SE2 SampleInstead(const SE2& /*start*/, const SE2& world_T_previous, const Control& control,
                    CounterRandom* random) const override {
    return motion_model_.Sample(world_T_previous, control, random);
  }

 private:
  int guesses_;
  MotionModel motion_model_;
};

class StartAtDraw : public MatchStart {
 public:
  explicit StartAtDraw(const MotionModel& motion_model) : motion_model_(motion_model) {}

  SE2 Choose(const SE2& world_T_previous, const Control& control,
             scan_matching::EndpointModel* /*model*/, CounterRandom* random) const override {
    return motion_model_.Sample(world_T_previous, control, random);
  }

  // The particle has been drawn already.
  SE2 SampleInstead(const SE2& start, const SE2& /*world_T_previous*/, const Control& /*control*/,
                    CounterRandom* /*random*/) const override {
    return start;
  }

 private:
  MotionModel motion_model_;
};

}  // namespace

std::shared_ptr<const MatchStart> MakeMatchStart(const MatchStart::Options& options,
                                                 const MotionModel& motion_model) {
  if (options.kind == MatchStart::Kind::kDraw) return std::make_shared<StartAtDraw>(motion_model);
  return std::make_shared<StartAtPrediction>(options.guesses, motion_model);
}

}  // namespace gmapping_spa::particle_filter
