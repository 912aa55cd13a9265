// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/slam_flags.h"

#include <gflags/gflags.h>

#include <stdexcept>
#include <string>

#include "experiments/apps/backend_flags.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/apps/graph_flags.h"
#include "experiments/apps/slam_option_names.h"

namespace {

using gmapping_spa::SlamOptions;
using gmapping_spa::apps::kLikelihoodNames;
using gmapping_spa::apps::kMatchStartNames;
using gmapping_spa::apps::kMotionNoiseNames;
using gmapping_spa::apps::kOdometryNames;
using gmapping_spa::apps::kProposalNames;
using gmapping_spa::apps::kScanMatcherNames;

const SlamOptions kSlam;

}  // namespace

DEFINE_int32(particles, kSlam.particles,
             "Number of particles of the filter, from 1: hypotheses of the trajectory, each with a "
             "map of its own.");
DEFINE_uint64(seed, kSlam.seed,
              "Seed of all random numbers: the same input, flags and seed give the same results.");
DEFINE_int32(
    threads, kSlam.threads,
    "Number of threads that share the particles, from 1 to 1024; results do not depend on it.");

DEFINE_double(linear_update_m, kSlam.linear_update_m,
              "Distance driven in m, from 0, after which the filter is updated. With scans of n < "
              "90 beams the distance is multiplied by (n / 90)^1.5.");
DEFINE_double(angular_update_rad, kSlam.angular_update_rad,
              "Angle turned in rad, from 0, after which the filter is updated. With scans of n < "
              "90 beams the angle is multiplied by (n / 90)^1.5.");
DEFINE_double(resample_threshold, kSlam.resample_threshold,
              "Particles are resampled when their effective number N_eff (eq. 17) falls below this "
              "part, 0 to 1, of their number.");
DEFINE_string(
    odometry, NameOf(kOdometryNames, kSlam.odometry),
    "Control input of the filter: raw (the log's odometry, right or wrong, as GMapping takes it), "
    "wheel (the log's odometry without impossible steps; scans tell how far to trust it), "
    "lidar (every scan is matched with the last ones, the wheels are a part of the prior) "
    "or lidar_only (scans alone; the log's odometry is not used).");
DEFINE_double(
    max_speed_m_s, kSlam.max_speed_m_s,
    "Highest speed of the robot in m/s, from 0.01; a faster step of the odometry is left out.");
DEFINE_double(max_turn_rad_s, kSlam.max_turn_rad_s,
              "Highest turn rate of the robot in rad/s, from 0.01; a faster step of the odometry "
              "is left out.");
DEFINE_string(
    sweep_duration_s, "auto",
    "Time in s, from -1 to 1, from the first beam of a scan to the last one, by which the scans of "
    "a moving robot are deskewed. Negative: the last beam is measured first; 0: all beams at once; "
    "auto: what a bag says (time_increment), unless scans bend otherwise, else learned from how "
    "they bend when the robot turns. Not for --odometry=raw.");
DEFINE_string(scan_matcher, NameOf(kScanMatcherNames, kSlam.scan_matcher),
              "Scan matcher of the particles: hill_climbing or gauss_newton.");
DEFINE_string(match_start, NameOf(kMatchStartNames, kSlam.match_start),
              "Where the scan matching of a particle starts: prediction (that of the odometry, or "
              "the best of --initial_guesses) or draw (one draw from the motion model, which is "
              "also the particle's pose if the match fails, as in GMapping).");
DEFINE_int32(initial_guesses, kSlam.initial_guesses,
             "Number of draws from the motion model, from 0, among which scan matching chooses its "
             "start, besides the odometry's prediction; without effect with --match_start=draw.");
DEFINE_string(proposal, NameOf(kProposalNames, kSlam.proposal),
              "Pose of a particle after a scan match: gaussian (drawn from the improved proposal, "
              "the Gaussian of scan and odometry around the match, and weighted by its integral) "
              "or match (the match itself, weighted by its likelihood, as GMapping's program "
              "does).");
DEFINE_double(
    obs_sigma_gain, kSlam.obs_sigma_gain,
    "Weights of particles are flattened by the exponent 1 / (gain * number of particles), with "
    "this gain above 0, since neighboring beams are not independent; GMapping's ogain.");

DEFINE_double(resolution_m, kSlam.resolution_m,
              "Edge length of a cell of all maps in m, from 0.005 to 10.");
DEFINE_double(grid_occupied_threshold, kSlam.grid_occupied_threshold,
              "For scan matching, a cell is occupied when more than this part, 0 to 1, of the "
              "beams that met it ended in it. 0: one hit is enough, forever.");
DEFINE_double(occupied_threshold, kSlam.occupied_threshold,
              "In the map written, a cell is occupied when more than this part, 0 to 1, of the "
              "beams that met it ended in it.");
DEFINE_bool(no_return_clears, kSlam.no_return_clears,
            "Beams without return mark the map as free up to --usable_range_m.");

DEFINE_double(match_linear_step_m, kSlam.match_linear_step_m,
              "First step of hill-climbing scan matching in the position, m, from 0.001 to 10.");
DEFINE_double(match_angular_step_rad, kSlam.match_angular_step_rad,
              "First step of hill-climbing scan matching in the heading, rad, from 0.0001 to 3.");
DEFINE_int32(match_refinements, kSlam.match_refinements,
             "Number of times, from 0 to 20, that hill-climbing scan matching halves its steps "
             "before it ends.");
DEFINE_double(
    match_noise_m, kSlam.match_noise_m,
    "Gauss-Newton scan matching: standard deviation of a beam's end point in m, from 0.001.");
DEFINE_double(match_robust_sigmas, kSlam.match_robust_sigmas,
              "Gauss-Newton scan matching: width of the Cauchy loss, above 0, in standard "
              "deviations of a beam's end point; farther beams lose weight.");
DEFINE_double(
    match_min_score, kSlam.match_min_score,
    "A particle's scan match has failed when its mean score per beam, 0 to 1, is below this.");
DEFINE_double(score_sigma_m, kSlam.score_sigma_m,
              "Hill-climbing scan matching: standard deviation in m, from 0.001, of the Gaussian "
              "that scores a beam by the distance of its end point to the nearest hit of the map.");
DEFINE_bool(free_cell_in_front, kSlam.free_cell_in_front,
            "In hill-climbing scan matching and with --likelihood=nearest_hit, a hit of the map "
            "explains a beam only where the cell before the hit, toward the laser, is not "
            "occupied. GMapping's program has this rule without effect.");
DEFINE_string(likelihood, NameOf(kLikelihoodNames, kSlam.likelihood),
              "Distance of a beam's end point in the likelihood, for weights and proposals: "
              "surface (to the surface that hits nearby form) or nearest_hit (to the nearest hit "
              "within a cell, as in GMapping).");
DEFINE_double(likelihood_sigma_m, kSlam.likelihood_sigma_m,
              "Likelihood of a scan: standard deviation of a beam's end point in m, from 0.001.");
DEFINE_double(likelihood_gain, kSlam.likelihood_gain,
              "Likelihood of a scan: exponent, above 0; below 1, since neighboring beams share "
              "their errors.");
DEFINE_bool(unseen_is_miss, kSlam.unseen_is_miss,
            "Likelihood of a scan: a beam that ends where no beam has been yet counts as one that "
            "does not fit the map, as in GMapping. Without it, such a beam does not count.");
DEFINE_double(unmatched_sigmas, kSlam.unmatched_sigmas,
              "Likelihood of a scan: distance in standard deviations, from 0.001 to 100, that a "
              "beam counts which the map does not explain.");

DEFINE_string(
    motion_noise, NameOf(kMotionNoiseNames, kSlam.motion_noise),
    "Motion model: what noise is added to: update (the motion between two updates as a whole) or "
    "scan "
    "(the odometry's increment of each scan, so that a particle walks along at random, as in "
    "GMapping). --motion_linear_... and the like are the standard deviations for that motion.");
DEFINE_double(motion_linear_per_linear, kSlam.motion_linear_per_linear,
              "Motion model: standard deviation of the position along the motion, m per m driven, "
              "from 0 to 10 (GMapping's srr).");
DEFINE_double(motion_linear_per_angular, kSlam.motion_linear_per_angular,
              "Motion model: standard deviation of the position, m per rad turned, from 0 to 10 "
              "(GMapping's str).");
DEFINE_double(motion_lateral_per_linear, kSlam.motion_lateral_per_linear,
              "Motion model: standard deviation of the position across the motion, m per m driven, "
              "from 0 to 10.");
DEFINE_double(motion_angular_per_linear, kSlam.motion_angular_per_linear,
              "Motion model: standard deviation of the heading, rad per m driven, from 0 to 10 "
              "(GMapping's srt).");
DEFINE_double(motion_angular_per_angular, kSlam.motion_angular_per_angular,
              "Motion model: standard deviation of the heading, rad per rad turned, from 0 to 10 "
              "(GMapping's stt).");
DEFINE_double(motion_linear_floor_m, kSlam.motion_linear_floor_m,
              "Motion model: least standard deviation of the position, that of a robot that stands "
              "still, m, above 0, at most 10.");
DEFINE_double(motion_angular_floor_rad, kSlam.motion_angular_floor_rad,
              "Motion model: least standard deviation of the heading, that of a robot that stands "
              "still, rad, above 0, at most 3.");

namespace gmapping_spa::apps {
namespace {

void AddFilterOptions(SlamOptions* options) {
  options->particles = FLAGS_particles;
  options->seed = FLAGS_seed;
  options->threads = FLAGS_threads;
  options->linear_update_m = FLAGS_linear_update_m;
  options->angular_update_rad = FLAGS_angular_update_rad;
  options->resample_threshold = FLAGS_resample_threshold;
  options->obs_sigma_gain = FLAGS_obs_sigma_gain;
  options->odometry = OneOf("odometry", FLAGS_odometry, kOdometryNames);
  options->max_speed_m_s = FLAGS_max_speed_m_s;
  options->max_turn_rad_s = FLAGS_max_turn_rad_s;
  if (FLAGS_sweep_duration_s != "auto") {
    options->sweep_duration_s = Number("sweep_duration_s", FLAGS_sweep_duration_s);
  }
  options->resolution_m = FLAGS_resolution_m;
  options->grid_occupied_threshold = FLAGS_grid_occupied_threshold;
  options->occupied_threshold = FLAGS_occupied_threshold;
  options->no_return_clears = FLAGS_no_return_clears;
}

void AddMatchingOptions(SlamOptions* options) {
  options->scan_matcher = OneOf("scan_matcher", FLAGS_scan_matcher, kScanMatcherNames);
  options->match_start = OneOf("match_start", FLAGS_match_start, kMatchStartNames);
  options->initial_guesses = FLAGS_initial_guesses;
  options->match_linear_step_m = FLAGS_match_linear_step_m;
  options->match_angular_step_rad = FLAGS_match_angular_step_rad;
  options->match_refinements = FLAGS_match_refinements;
  options->match_noise_m = FLAGS_match_noise_m;
  options->match_robust_sigmas = FLAGS_match_robust_sigmas;
  options->match_min_score = FLAGS_match_min_score;
  options->score_sigma_m = FLAGS_score_sigma_m;
  options->free_cell_in_front = FLAGS_free_cell_in_front;
  options->proposal = OneOf("proposal", FLAGS_proposal, kProposalNames);
  options->likelihood = OneOf("likelihood", FLAGS_likelihood, kLikelihoodNames);
  options->likelihood_sigma_m = FLAGS_likelihood_sigma_m;
  options->likelihood_gain = FLAGS_likelihood_gain;
  options->unseen_is_miss = FLAGS_unseen_is_miss;
  options->unmatched_sigmas = FLAGS_unmatched_sigmas;
}

void AddMotionOptions(SlamOptions* options) {
  options->motion_noise = OneOf("motion_noise", FLAGS_motion_noise, kMotionNoiseNames);
  options->motion_linear_per_linear = FLAGS_motion_linear_per_linear;
  options->motion_lateral_per_linear = FLAGS_motion_lateral_per_linear;
  options->motion_linear_per_angular = FLAGS_motion_linear_per_angular;
  options->motion_angular_per_linear = FLAGS_motion_angular_per_linear;
  options->motion_angular_per_angular = FLAGS_motion_angular_per_angular;
  options->motion_linear_floor_m = FLAGS_motion_linear_floor_m;
  options->motion_angular_floor_rad = FLAGS_motion_angular_floor_rad;
}

}  // namespace

FlagGroups SlamFlagGroups() {
  const FlagGroups filter = {
      {"filter",
       "Particle filter",
       {"particles", "seed", "threads", "linear_update_m", "angular_update_rad", "proposal",
        "obs_sigma_gain", "resample_threshold"}},
      {"odometry",
       "Odometry and deskewing",
       {"odometry", "max_speed_m_s", "max_turn_rad_s", "sweep_duration_s"}},
      {"motion_model",
       "Motion model",
       {"motion_noise", "motion_linear_per_linear", "motion_linear_per_angular",
        "motion_lateral_per_linear", "motion_angular_per_linear", "motion_angular_per_angular",
        "motion_linear_floor_m", "motion_angular_floor_rad"}},
      {"scan_matching",
       "Scan matching",
       {"scan_matcher", "match_start", "initial_guesses", "match_min_score", "match_noise_m",
        "match_robust_sigmas", "match_linear_step_m", "match_angular_step_rad", "match_refinements",
        "score_sigma_m", "free_cell_in_front"}},
      {"likelihood",
       "Likelihood of a scan",
       {"likelihood", "likelihood_sigma_m", "likelihood_gain", "unmatched_sigmas",
        "unseen_is_miss"}},
      {"maps",
       "Maps",
       {"resolution_m", "grid_occupied_threshold", "occupied_threshold", "no_return_clears"}}};
  return Join({filter, GraphFlagGroups(), BackendFlagGroups()});
}

SlamOptions SlamOptionsFromFlags() {
  SlamOptions options;
  AddFilterOptions(&options);
  AddMatchingOptions(&options);
  AddMotionOptions(&options);
  AddGraphOptions(&options);
  options.backend = BackendFromFlags();
  options.optimizer = OptionsFromFlags();
  options.gnc = GncFromFlags();
  try {
    CheckSlamOptions(options);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(std::string("--") + error.what());
  }
  return options;
}

}  // namespace gmapping_spa::apps
