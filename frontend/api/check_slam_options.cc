// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>
#include <stdexcept>

#include "frontend/api/slam_options.h"

namespace gmapping_spa {
namespace {

template <typename T>
void Expect(const char* name, T value, T min, T max) {
  if (value >= min && value <= max) return;  // not a number lies in no range
  std::ostringstream message;
  message << name << ": expected a value from " << min << " to " << max << ", found " << value;
  throw std::invalid_argument(message.str());
}

void ExpectPositive(const char* name, double value) { Expect(name, value, 1e-6, 1e6); }
void ExpectNotNegative(const char* name, double value) { Expect(name, value, 0.0, 1e6); }
void ExpectPart(const char* name, double value) { Expect(name, value, 0.0, 1.0); }
// Standard deviations of a motion: more would throw particles out of every map.
void ExpectMotionNoise(const char* name, double value) { Expect(name, value, 0.0, 10.0); }

void CheckFilter(const SlamOptions& o) {
  Expect("particles", o.particles, 1, 100000);
  Expect("threads", o.threads, 1, 1024);
  ExpectNotNegative("linear_update_m", o.linear_update_m);
  ExpectNotNegative("angular_update_rad", o.angular_update_rad);
  ExpectNotNegative("resample_threshold", o.resample_threshold);
  ExpectPositive("obs_sigma_gain", o.obs_sigma_gain);
  Expect("max_speed_m_s", o.max_speed_m_s, 0.01, 1000.0);
  Expect("max_turn_rad_s", o.max_turn_rad_s, 0.01, 1000.0);
  Expect("sweep_duration_s", o.sweep_duration_s.value_or(0.0), -1.0, 1.0);
  ExpectMotionNoise("motion_linear_per_linear", o.motion_linear_per_linear);
  ExpectMotionNoise("motion_linear_per_angular", o.motion_linear_per_angular);
  ExpectMotionNoise("motion_lateral_per_linear", o.motion_lateral_per_linear);
  ExpectMotionNoise("motion_angular_per_linear", o.motion_angular_per_linear);
  ExpectMotionNoise("motion_angular_per_angular", o.motion_angular_per_angular);
  Expect("motion_linear_floor_m", o.motion_linear_floor_m, 1e-6, 10.0);
  Expect("motion_angular_floor_rad", o.motion_angular_floor_rad, 1e-6, 3.0);
}

void CheckMatching(const SlamOptions& o) {
  Expect("resolution_m", o.resolution_m, 0.005, 10.0);
  ExpectNotNegative("grid_occupied_threshold", o.grid_occupied_threshold);
  ExpectNotNegative("occupied_threshold", o.occupied_threshold);
  Expect("initial_guesses", o.initial_guesses, 0, 100000);
  Expect("match_linear_step_m", o.match_linear_step_m, 1e-3, 10.0);
  Expect("match_angular_step_rad", o.match_angular_step_rad, 1e-4, 3.0);
  Expect("match_refinements", o.match_refinements, 0, 20);
  Expect("match_noise_m", o.match_noise_m, 1e-3, 100.0);
  ExpectPositive("match_robust_sigmas", o.match_robust_sigmas);
  ExpectNotNegative("match_min_score", o.match_min_score);
  Expect("score_sigma_m", o.score_sigma_m, 1e-3, 100.0);
  Expect("likelihood_sigma_m", o.likelihood_sigma_m, 1e-3, 100.0);
  ExpectPositive("likelihood_gain", o.likelihood_gain);
  Expect("unmatched_sigmas", o.unmatched_sigmas, 1e-3, 100.0);
}

void CheckGraph(const SlamOptions& o) {
  ExpectNotNegative("closure_min_path_length_m", o.closure_min_path_length_m);
  Expect("closure_max_distance_m", o.closure_max_distance_m, 0.0, 100.0);
  ExpectPart("closure_drift_m_per_m", o.closure_drift_m_per_m);
  ExpectPart("closure_drift_rad_per_m", o.closure_drift_rad_per_m);
  Expect("closure_min_score", o.closure_min_score, 0.01, 1.0);
  ExpectPart("closure_max_runner_up_score", o.closure_max_runner_up_score);
  ExpectPart("closure_min_overlap", o.closure_min_overlap);
  ExpectPart("closure_min_inlier_ratio", o.closure_min_inlier_ratio);
  ExpectPositive("closure_information_gain", o.closure_information_gain);
  Expect("max_iterations", o.optimizer.max_iterations, 0, 1000000000);
  ExpectNotNegative("cost_tolerance", o.optimizer.cost_tolerance);
  ExpectPositive("loss_scale", o.optimizer.loss.scale);
  Expect("optimize_every", o.optimize_every, 1, 1000000);
  Expect("lockstep_scans", o.lockstep_scans, 1, 1000000);
  ExpectNotNegative("graph_timeout_s", o.graph_timeout_s);
  Expect("refine", o.refine, 0, 1000);
}

}  // namespace

// Limits are wide, but such that no value can overflow a cell index or ask for endless work.
void CheckSlamOptions(const SlamOptions& options) {
  if (options.odometry == SlamOptions::Odometry::kRaw && options.sweep_duration_s) {
    throw std::invalid_argument(
        "sweep_duration_s: expected none with raw odometry, which deskews no scan");
  }
  CheckFilter(options);
  CheckMatching(options);
  CheckGraph(options);
}

}  // namespace gmapping_spa
