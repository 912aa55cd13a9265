// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/api/slam_options.h"

namespace gmapping_spa {
namespace {

// What PlainGmapping and Paper share: the particle filter as published.
SlamOptions PublishedFilter() {
  SlamOptions options;
  // A pose drawn along with each scan from the odometry: srr 0.1, str 0.1, srt 0.2, stt 0.2.
  options.odometry = SlamOptions::Odometry::kRaw;
  options.motion_noise = SlamOptions::MotionNoise::kScan;
  options.motion_linear_per_linear = 0.1;
  options.motion_lateral_per_linear = 0.03;
  options.motion_linear_per_angular = 0.1;
  options.motion_angular_per_linear = 0.2;
  options.motion_angular_per_angular = 0.2;
  options.motion_linear_floor_m = 1e-5;
  options.motion_angular_floor_rad = 1e-5;
  // From there it climbs to a better score, exp(-d^2 / 0.05) a beam, on hits that nothing clears.
  options.match_start = SlamOptions::MatchStart::kDraw;
  options.scan_matcher = SlamOptions::ScanMatcher::kHillClimbing;
  options.score_sigma_m = 0.158;
  options.free_cell_in_front = false;
  options.grid_occupied_threshold = 0.0;
  options.match_min_score = 0.0;
  // That is the pose; the weight is exp(-d^2 / 0.075) a beam, exp(-6.67) where nothing is near.
  options.proposal = SlamOptions::Proposal::kMatch;
  options.likelihood = SlamOptions::Likelihood::kNearestHit;
  options.likelihood_sigma_m = 0.19365;
  options.unmatched_sigmas = 3.6515;
  options.likelihood_gain = 1.0;
  options.unseen_is_miss = true;
  options.obs_sigma_gain = 3.0;
  options.edge_measurement = SlamOptions::EdgeMeasurement::kParticle;
  options.final_optimization = false;
  return options;
}

}  // namespace

SlamOptions SlamOptions::PlainGmapping() {
  SlamOptions options = PublishedFilter();
  options.particles = 30;
  options.backend = "none";
  options.loop_closure = false;
  options.edge_information = EdgeInformation::kConstant;
  return options;
}

SlamOptions SlamOptions::Paper() {
  SlamOptions options = PublishedFilter();
  options.correction = Correction::kPose;
  return options;
}

}  // namespace gmapping_spa
