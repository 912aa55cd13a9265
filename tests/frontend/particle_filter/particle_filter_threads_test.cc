// SPDX-License-Identifier: BSD-3-Clause
// Particles shared out among threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "frontend/particle_filter/particle_filter.h"
#include "tests/frontend/particle_filter/tour.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;

TEST(ParticleFilterThreads, ResultIsTheSameToTheBitWhateverTheNumberOfThreads) {
  const Tour one(Particles(6, 1));
  const bool resampled = std::any_of(one.updates.begin(), one.updates.end(),
                                     [](const auto& update) { return update.resampled; });
  EXPECT_TRUE(resampled);
  for (const int threads : {2, 4}) {
    const Tour many(Particles(6, threads));
    EXPECT_TRUE(SamePoses(one.filter, many.filter)) << threads;
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_TRUE(SameMap(one.filter.particles()[i].map, many.filter.particles()[i].map)) << i;
    }
  }
}

TEST(ParticleFilterThreads, GoesOnAlikeAfterCorrectionsWithOneThreadOrTwo) {
  for (const bool histories : {false, true}) {
    Tour one(Particles(4, 1), 5), two(Particles(4, 2), 5);
    for (Tour* tour : {&one, &two}) {
      for (int round = 0; round < 2; ++round) {
        // A small one, so that scans still match maps that did not move along.
        PathCorrection correction{PosesOf(tour->filter.Path(tour->filter.BestParticle())), {}};
        correction.after = correction.before;
        correction.after.back() = correction.after.back() * SE2{0.03, -0.02, 0.01};
        if (histories) {
          tour->filter.CorrectHistories(correction, ScanOnDrive);
        } else {
          tour->filter.CorrectCurrentPoses(correction);
        }
        tour->Continue(4);
      }
    }
    EXPECT_TRUE(SamePoses(one.filter, two.filter));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_TRUE(SameMap(one.filter.particles()[i].map, two.filter.particles()[i].map)) << i;
    }
    for (const ParticleFilter::UpdateResult& update : one.updates)
      EXPECT_EQ(update.failed_matches, 0);
  }
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
