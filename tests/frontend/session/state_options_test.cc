// SPDX-License-Identifier: BSD-3-Clause
// Sessions of runs with other options than usual.
#include <gtest/gtest.h>

#include "tests/frontend/drifting_scans.h"
#include "tests/frontend/session/resumed_run.h"

namespace gmapping_spa::session {
namespace {

Scans ScansOnTheFirst(double length_m) {
  return synthetic::DriftingScans(synthetic::DriveOnRing(0, length_m, 0.25));
}

TEST(SessionStateOptions, ManyParticlesGoOnToTheSameBytes) {
  SlamOptions options = QuickOptions();
  options.particles = 12;
  options.match_start = SlamOptions::MatchStart::kDraw;
  options.odometry = SlamOptions::Odometry::kWheel;
  options.correction = SlamOptions::Correction::kPose;
  const auto whole = ExpectSameWhenResumed(options, ScansOnTheFirst(40), {60, 130});
  EXPECT_GT(whole->counts().resamplings, 0);
}

TEST(SessionStateOptions, OdometryOfEveryKindGoesOnToTheSameBytes) {
  for (const auto odometry : {SlamOptions::Odometry::kRaw, SlamOptions::Odometry::kLidarOnly}) {
    SlamOptions options = QuickOptions();
    options.odometry = odometry;
    options.motion_noise = SlamOptions::MotionNoise::kScan;
    ExpectSameWhenResumed(options, ScansOnTheFirst(20), {35, 61});
  }
}

}  // namespace
}  // namespace gmapping_spa::session
