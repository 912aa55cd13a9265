// SPDX-License-Identifier: BSD-3-Clause
// Everything that can be chosen about SLAM.
#ifndef GMAPPING_SPA_FRONTEND_API_SLAM_OPTIONS_H_
#define GMAPPING_SPA_FRONTEND_API_SLAM_OPTIONS_H_

#include <cstdint>
#include <optional>
#include <string>

#include "backend/plugin/optimizer.h"

namespace gmapping_spa {

/// Each member is the flag of the same name of the executable `gmapping_spa`, whose `--help`
/// says more; the defaults are what it runs without flags. A plain value: copy it, compare it.
struct SlamOptions {
  /// What the README calls improved GMapping: the defaults.
  static SlamOptions Improved() { return {}; }
  /// GMapping as its authors published it, without a back end: experiments/flags/gmapping.flags.
  static SlamOptions PlainGmapping();
  /// Tao et al. 2021 read literally: experiments/flags/paper.flags.
  static SlamOptions Paper();

  // The filter.
  int particles = 5;
  std::uint64_t seed = 1;  ///< of all random numbers
  int threads = 1;         ///< for the particles; results do not depend on it
  /// The filter is updated after this much motion; sooner with scans of fewer than 90 beams.
  double linear_update_m = 1.0;
  double angular_update_rad = 0.5;
  /// Resampling when N_eff falls below this part of the number of particles, eq. (17).
  double resample_threshold = 0.5;
  /// Weights are flattened by the exponent 1 / (gain * particles).
  double obs_sigma_gain = 1.0;

  // The control input.
  enum class Odometry : std::uint8_t {
    kRaw,       ///< the odometry of the scans as it is
    kWheel,     ///< without impossible steps; scans tell how far to trust it
    kLidar,     ///< every scan is matched with the last ones, the wheels a part of the prior
    kLidarOnly  ///< scans alone; LaserScan::odom_T_robot is not looked at
  };
  Odometry odometry = Odometry::kLidar;
  double max_speed_m_s = 5.0;   ///< of the robot; a faster step of the odometry is left out
  double max_turn_rad_s = 6.0;  ///< likewise
  /// Time from the first beam of a scan to the last one, s; nothing: learned.
  std::optional<double> sweep_duration_s = std::nullopt;

  // Maps.
  double resolution_m = 0.05;  ///< size of a cell of all maps: particles', local and final ones
  /// For matching with the map of a particle, a cell is an obstacle when more than this part of the
  /// beams that met it ended in it.
  double grid_occupied_threshold = 0.1;
  double occupied_threshold = 0.25;  ///< likewise, for the map that is handed out
  bool no_return_clears = false;     ///< whether beams without return mark the map as free

  // Scan matching.
  enum class ScanMatcher : std::uint8_t { kHillClimbing, kGaussNewton };
  ScanMatcher scan_matcher = ScanMatcher::kGaussNewton;  ///< of the particles
  enum class MatchStart : std::uint8_t { kPrediction, kDraw };
  MatchStart match_start = MatchStart::kPrediction;
  int initial_guesses = 0;               ///< draws among which kPrediction chooses its start
  double match_linear_step_m = 0.05;     ///< first step of hill climbing
  double match_angular_step_rad = 0.05;  ///< first step of hill climbing
  int match_refinements = 5;             ///< of hill climbing's steps
  double match_noise_m = 0.02;           ///< of an end point, in all Gauss-Newton matching
  double match_robust_sigmas = 2.0;      ///< width of its Cauchy weight
  double match_min_score = 0.2;          ///< a particle's match below this mean score has failed
  double score_sigma_m = 0.05;           ///< of the score of a beam
  bool free_cell_in_front = true;        ///< whether a wall is seen from its own side only

  // The likelihood of a scan, for weights and proposals.
  enum class Proposal : std::uint8_t { kGaussian, kMatch };
  Proposal proposal = Proposal::kGaussian;
  enum class Likelihood : std::uint8_t { kSurface, kNearestHit };
  Likelihood likelihood = Likelihood::kSurface;
  double likelihood_sigma_m = 0.03;    ///< of a beam's end point
  double likelihood_gain = 1.0 / 3.0;  ///< exponent: neighboring beams share their errors
  bool unseen_is_miss = false;         ///< whether ending in unseen space counts against a pose
  double unmatched_sigmas = 5.0;       ///< at most this far off is a beam

  // The motion model, eq. (9): standard deviations.
  enum class MotionNoise : std::uint8_t { kUpdate, kScan };
  MotionNoise motion_noise =
      MotionNoise::kUpdate;                  ///< added once an update, or to each scan's step
  double motion_linear_per_linear = 0.05;    ///< along the motion, m per m
  double motion_lateral_per_linear = 0.03;   ///< across the motion, m per m
  double motion_linear_per_angular = 0.03;   ///< m per rad
  double motion_angular_per_linear = 0.03;   ///< rad per m
  double motion_angular_per_angular = 0.05;  ///< rad per rad
  double motion_linear_floor_m = 0.01;       ///< of a robot that stands still
  double motion_angular_floor_rad = 0.005;   ///< of a robot that stands still

  // The pose graph.
  /// Lidar odometry needs kLidar or kLidarOnly; with other odometry it is as kParticle.
  enum class EdgeMeasurement : std::uint8_t { kLidarOdometry, kParticle };
  EdgeMeasurement edge_measurement = EdgeMeasurement::kLidarOdometry;
  enum class EdgeInformation : std::uint8_t { kProposal, kHessian, kConstant };
  EdgeInformation edge_information = EdgeInformation::kProposal;
  bool loop_closure = true;
  double closure_min_path_length_m = 15.0;  ///< path length from which on two nodes may be closed
  double closure_max_distance_m = 4.0;      ///< between two nodes, besides three sigmas of drift
  double closure_drift_m_per_m = 0.015;     ///< standard deviation expected
  double closure_drift_rad_per_m = 0.0005;  ///< standard deviation expected
  bool closure_everywhere = true;  ///< whether places are recognized however large the drift
  double closure_min_score = 0.5;  ///< of correlative matching, 0 to 1
  double closure_max_runner_up_score = 0.9;  ///< part of the best score: above, it is ambiguous
  double closure_min_overlap = 0.5;          ///< part of the new end points in the known old map
  double closure_min_inlier_ratio = 0.6;     ///< part of those that end at obstacles
  double closure_information_gain = 0.02;    ///< factor on the information of the match

  // The back end.
  std::string backend = "spa";  ///< name or path of a plugin, see LoadOptimizer
  /// How it optimizes. Closures found by a machine are never beyond doubt: their loss tells wrong
  /// ones from right ones.
  gmapping_spa::backend::Options optimizer = {
      .loss = {gmapping_spa::backend::LossKind::kMixture, 3.0}, .settings = {}};
  bool gnc = true;          ///< whether a truncated loss is approached by graduated non-convexity
  int optimize_every = 20;  ///< so many nodes, and after each closure
  enum class GraphThread : std::uint8_t {
    kLockstep,  ///< taken over lockstep_scans after the start: the same results every time
    kAsync,     ///< as soon as it is there
    kInline     ///< at the next scan, which waits for it
  };
  GraphThread graph_thread = GraphThread::kLockstep;
  int lockstep_scans = 10;
  double graph_timeout_s =
      3.0;  ///< longest time to wait for a result that is due; 10 times at the end
  enum class Correction : std::uint8_t { kPose, kTrajectory };
  Correction correction = Correction::kTrajectory;  ///< what eq. (14) moves of each particle
  bool final_optimization =
      true;        ///< whether Finish closes, optimizes and builds the map once more
  int refine = 1;  ///< how often it aligns all scans with the map

  friend bool operator==(const SlamOptions&, const SlamOptions&) = default;
};

/// Throws std::invalid_argument "<member>: expected a value from <min> to <max>, found <value>"
/// when a number is out of range.
void CheckSlamOptions(const SlamOptions& options);

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_FRONTEND_API_SLAM_OPTIONS_H_
