#include "experiments/apps/slam_flags.h"

#include <gflags/gflags.h>

#include <string>

#include "experiments/apps/flag_checks.h"
#include "experiments/apps/graph_flags.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/hill_climbing.h"

namespace {
const gmapping_spa::frontend::ImprovedGmapping::Options kSlam;
const auto& kMotion = kSlam.filter.motion;
const gmapping_spa::scan_matching::HillClimbing::Options kHillClimbing;
const gmapping_spa::scan_matching::GaussNewton::Options kGaussNewton;
const gmapping_spa::scan_matching::EndpointModel::Options kEndpoint;
}  // namespace

DEFINE_int32(particles, kSlam.filter.particles, "Number of particles of the filter.");
DEFINE_uint64(seed, kSlam.filter.seed,
              "Seed of all random numbers: the same input, flags and seed give the same results.");
DEFINE_int32(threads, kSlam.filter.threads,
             "Number of threads for the particles; the results do not depend on it.");

DEFINE_double(linear_update_m, kSlam.linear_update_m,
              "The filter is updated after this much driving, m; with scans of fewer than 90 beams "
              "sooner, by the square of their number.");
DEFINE_double(
    angular_update_rad, kSlam.angular_update_rad,
    "The filter is updated after this much turning, rad; with scans of fewer than 90 beams "
    "sooner, as with --linear_update_m.");
DEFINE_double(
    resample_threshold, kSlam.filter.resample_threshold,
    "Particles are resampled when N_eff falls below this part, 0 to 1, of their number (eq. 17).");
DEFINE_string(
    odometry, "scan_matched",
    "Control input of the filter: raw (the log's odometry, right or wrong, as GMapping takes it), "
    "wheel (the log's odometry without impossible steps; scans tell how far to trust it), "
    "scan_matched (every scan is matched with the last ones, the wheels are a part of the prior) "
    "or lidar_only (scans alone; the log's odometry is not used).");
DEFINE_double(max_speed_m_s, kSlam.control.check.max_speed_m_s,
              "Highest speed of the robot, m/s. A faster step of the odometry is left out.");
DEFINE_double(max_turn_rad_s, kSlam.control.check.max_turn_rad_s,
              "Highest turn rate of the robot, rad/s. A faster step of the odometry is left out.");
DEFINE_string(
    sweep_duration_s, "auto",
    "Time from the first beam of a scan to the last one, s, from -1 to 1, by which scans of a "
    "moving robot are deskewed; negative: the first beam is measured last; 0: all at once; auto: "
    "learned from how scans bend when the robot turns. Without effect on --odometry=raw.");
DEFINE_string(scan_matcher, "gauss_newton",
              "Scan matcher of the particles: hill_climbing or gauss_newton.");
DEFINE_string(match_start, "prediction",
              "Where the scan matching of a particle starts: prediction (that of the odometry, or "
              "the best of --initial_guesses) or draw (one draw from the motion model, which is "
              "also the particle's pose if the match fails, as in GMapping).");
DEFINE_int32(initial_guesses, kSlam.filter.match_start.guesses,
             "Draws from the motion model among which scan matching chooses its start, besides the "
             "odometry's prediction; without effect on --match_start=draw.");
DEFINE_string(proposal, "gaussian",
              "Pose of a particle after a scan match: gaussian (drawn from the improved proposal, "
              "the Gaussian of scan and odometry around the match, and weighted by its integral) "
              "or match (the match itself, weighted by its likelihood, as GMapping's program "
              "does).");
DEFINE_double(
    obs_sigma_gain, kSlam.filter.obs_sigma_gain,
    "Weights of particles are flattened by the exponent 1 / (gain * number of particles), so that "
    "neighboring beams are not counted as independent; GMapping's ogain.");

DEFINE_double(resolution_m, kSlam.filter.grid.resolution_m, "Size of a map cell, m.");
DEFINE_double(full_threshold, kSlam.filter.grid.full_threshold,
              "For scan matching, a cell is an obstacle when more than this part, 0 to 1, of the "
              "beams that met it ended in it. 0: one hit makes it so for ever.");
DEFINE_double(occupied_threshold, 0.25,
              "In the map written, a cell is occupied when more than this part, 0 to 1, of the "
              "beams that met it ended in it.");
DEFINE_bool(no_return_clears, kSlam.filter.registration.no_return_clears,
            "Beams without return mark the map as free up to --usable_range_m.");

DEFINE_double(match_linear_step_m, kHillClimbing.linear_step_m,
              "First step of hill climbing in the position, m.");
DEFINE_double(match_angular_step_rad, kHillClimbing.angular_step_rad,
              "First step of hill climbing in the heading, rad.");
DEFINE_int32(match_halvings, kHillClimbing.halvings,
             "Number of times that hill climbing halves its steps before it ends.");
DEFINE_double(match_noise_m, kGaussNewton.noise_sigma_m,
              "Standard deviation in m of a beam's end point in Gauss-Newton scan matching.");
DEFINE_double(match_robust_sigmas, kGaussNewton.robust_sigmas,
              "Gauss-Newton scan matching lowers the weight of a beam (Cauchy) from this many "
              "standard deviations on.");
DEFINE_double(match_min_score, kHillClimbing.min_score,
              "A particle's scan match with a mean score a beam (0 to 1) below this has failed.");
DEFINE_double(score_sigma_m, kEndpoint.score_sigma_m,
              "Hill climbing scores a beam by a Gaussian of its distance to the nearest hit; its "
              "standard deviation, m.");
DEFINE_bool(free_cell_in_front, kEndpoint.free_cell_in_front,
            "For the score of hill climbing and --likelihood=nearest_hit, a hit of the map "
            "explains a beam only where the cell before it, toward the laser, is not an obstacle "
            "as well. GMapping's program has this rule without effect.");
DEFINE_string(likelihood, "surface",
              "Distance of a beam's end point in the likelihood, for weights and proposals: "
              "surface (to the surface that hits nearby form) or nearest_hit (to the nearest hit "
              "within a cell, as in GMapping).");
DEFINE_double(likelihood_sigma_m, kEndpoint.likelihood_sigma_m,
              "Standard deviation in m of a beam's end point in the likelihood.");
DEFINE_double(likelihood_gain, kEndpoint.likelihood_gain,
              "Exponent of the likelihood of a scan, 0 to 1: less than 1, since neighboring beams "
              "share their errors.");
DEFINE_bool(unseen_is_miss, kEndpoint.unseen_is_miss,
            "For weights and proposals, a beam that ends where no beam has been yet counts as one "
            "that does not fit the map, as in GMapping; else as one that says nothing.");
DEFINE_double(unmatched_sigmas, kEndpoint.unmatched_sigmas,
              "In the likelihood, a beam that the map does not explain counts as this many "
              "standard deviations off.");

DEFINE_string(motion_noise, "update",
              "Motion model: noise is added to the motion between two updates as a whole (update) "
              "or to the odometry's increment of each scan, so that a particle walks along at "
              "random (scan, as in GMapping). The standard deviations below are of that motion.");
DEFINE_double(motion_linear_per_linear, kMotion.linear_per_linear,
              "Motion model: standard deviation of the position along the motion, m per m driven "
              "(GMapping's srr).");
DEFINE_double(
    motion_linear_per_angular, kMotion.linear_per_angular,
    "Motion model: standard deviation of the position, m per rad turned (GMapping's str).");
DEFINE_double(
    motion_lateral_per_linear, kMotion.lateral_per_linear,
    "Motion model: standard deviation of the position across the motion, m per m driven.");
DEFINE_double(
    motion_angular_per_linear, kMotion.angular_per_linear,
    "Motion model: standard deviation of the heading, rad per m driven (GMapping's srt).");
DEFINE_double(
    motion_angular_per_angular, kMotion.angular_per_angular,
    "Motion model: standard deviation of the heading, rad per rad turned (GMapping's stt).");
DEFINE_double(motion_linear_floor_m, kMotion.linear_floor_m,
              "Motion model: standard deviation of the position of a robot that stands still, m.");
DEFINE_double(motion_angular_floor_rad, kMotion.angular_floor_rad,
              "Motion model: standard deviation of the heading of a robot that stands still, rad.");

namespace gmapping_spa::apps {
namespace {

using particle_filter::MatchStart;
using particle_filter::PoseSampling;
using Likelihood = scan_matching::EndpointModel::Likelihood;

// Limits are wide, but such that no value can overflow a cell index or ask for endless work.
double Positive(const char* name, double value) { return InRange(name, value, 1e-6, 1e6); }

double NotNegative(const char* name, double value) { return InRange(name, value, 0.0, 1e6); }

// Standard deviations of a motion: more would throw particles out of every map.
double MotionNoise(const char* name, double value) { return InRange(name, value, 0.0, 10.0); }

scan_matching::GaussNewton::Options GaussNewtonOptionsFromFlags() {
  return {.noise_sigma_m = InRange("match_noise_m", FLAGS_match_noise_m, 1e-3, 100.0),
          .robust_sigmas = Positive("match_robust_sigmas", FLAGS_match_robust_sigmas)};
}

scan_matching::HillClimbing::Options HillClimbingOptionsFromFlags() {
  return {.linear_step_m = InRange("match_linear_step_m", FLAGS_match_linear_step_m, 1e-3, 10.0),
          .angular_step_rad =
              InRange("match_angular_step_rad", FLAGS_match_angular_step_rad, 1e-4, 3.0),
          .halvings = InRange("match_halvings", FLAGS_match_halvings, 0, 20),
          .min_score = NotNegative("match_min_score", FLAGS_match_min_score)};
}

}  // namespace

frontend::ImprovedGmapping::Options SlamOptionsFromFlags() {
  frontend::ImprovedGmapping::Options options;
  options.linear_update_m = NotNegative("linear_update_m", FLAGS_linear_update_m);
  options.angular_update_rad = NotNegative("angular_update_rad", FLAGS_angular_update_rad);
  options.control.source =
      OneOf<frontend::OdometrySource>("odometry", FLAGS_odometry,
                                      {{"raw", frontend::OdometrySource::kRaw},
                                       {"wheel", frontend::OdometrySource::kWheel},
                                       {"scan_matched", frontend::OdometrySource::kScanMatched},
                                       {"lidar_only", frontend::OdometrySource::kLidarOnly}});
  sensor::OdometryCheck::Options& check = options.control.check;
  check.max_speed_m_s = InRange("max_speed_m_s", FLAGS_max_speed_m_s, 0.01, 1000.0);
  check.max_turn_rad_s = InRange("max_turn_rad_s", FLAGS_max_turn_rad_s, 0.01, 1000.0);
  particle_filter::ParticleFilter::Options& filter = options.filter;
  filter.particles = InRange("particles", FLAGS_particles, 1, 100000);
  filter.threads = InRange("threads", FLAGS_threads, 1, 1024);
  filter.seed = FLAGS_seed;
  filter.resample_threshold = NotNegative("resample_threshold", FLAGS_resample_threshold);
  filter.match_start = {
      .kind = OneOf<MatchStart::Kind>(
          "match_start", FLAGS_match_start,
          {{"prediction", MatchStart::Kind::kPrediction}, {"draw", MatchStart::Kind::kDraw}}),
      .guesses = InRange("initial_guesses", FLAGS_initial_guesses, 0, 100000)};
  filter.proposal = OneOf<PoseSampling::Kind>(
      "proposal", FLAGS_proposal,
      {{"gaussian", PoseSampling::Kind::kGaussian}, {"match", PoseSampling::Kind::kMatch}});
  filter.obs_sigma_gain = Positive("obs_sigma_gain", FLAGS_obs_sigma_gain);
  filter.grid.resolution_m = InRange("resolution_m", FLAGS_resolution_m, 0.005, 10.0);
  filter.grid.full_threshold = NotNegative("full_threshold", FLAGS_full_threshold);
  filter.registration.no_return_clears = FLAGS_no_return_clears;
  filter.endpoint = EndpointOptionsFromFlags();
  filter.motion = {
      .linear_per_linear = MotionNoise("motion_linear_per_linear", FLAGS_motion_linear_per_linear),
      .linear_per_angular =
          MotionNoise("motion_linear_per_angular", FLAGS_motion_linear_per_angular),
      .lateral_per_linear =
          MotionNoise("motion_lateral_per_linear", FLAGS_motion_lateral_per_linear),
      .angular_per_linear =
          MotionNoise("motion_angular_per_linear", FLAGS_motion_angular_per_linear),
      .angular_per_angular =
          MotionNoise("motion_angular_per_angular", FLAGS_motion_angular_per_angular),
      .linear_floor_m = InRange("motion_linear_floor_m", FLAGS_motion_linear_floor_m, 1e-6, 10.0),
      .angular_floor_rad =
          InRange("motion_angular_floor_rad", FLAGS_motion_angular_floor_rad, 1e-6, 3.0),
      .noise_at_each_scan =
          OneOf<bool>("motion_noise", FLAGS_motion_noise, {{"update", false}, {"scan", true}})};
  if (FLAGS_sweep_duration_s != "auto") {
    options.control.scan_odometry.sweep_duration_s =
        InRange("sweep_duration_s", Number("sweep_duration_s", FLAGS_sweep_duration_s), -1.0, 1.0);
  }
  options.control.scan_odometry.prior.max_speed_m_s = check.max_speed_m_s;
  options.control.scan_odometry.prior.max_turn_rad_s = check.max_turn_rad_s;
  // All that align scans do it alike; what counts as an obstacle or fits in the maps of particles,
  // concerns these alone.
  options.control.scan_odometry.grid.resolution_m = filter.grid.resolution_m;
  options.loop_closer.verifier.grid.resolution_m = filter.grid.resolution_m;
  for (scan_matching::GaussNewton::Options* aligns :
       {&options.control.scan_odometry.gauss_newton, &options.loop_closer.verifier.gauss_newton,
        &options.final_round.gauss_newton, &filter.edges.gauss_newton}) {
    *aligns = GaussNewtonOptionsFromFlags();
  }
  AddGraphOptions(&options);
  return options;
}

std::shared_ptr<const scan_matching::ScanMatcher> ScanMatcherFromFlags() {
  const bool gauss_newton = OneOf<bool>("scan_matcher", FLAGS_scan_matcher,
                                        {{"hill_climbing", false}, {"gauss_newton", true}});
  // Checked in any case: a bad value is a mistake, used or not.
  const scan_matching::HillClimbing::Options hill_climbing = HillClimbingOptionsFromFlags();
  if (gauss_newton) {
    scan_matching::GaussNewton::Options options = GaussNewtonOptionsFromFlags();
    options.min_score = NotNegative("match_min_score", FLAGS_match_min_score);
    return std::make_shared<scan_matching::GaussNewton>(options, EndpointOptionsFromFlags());
  }
  return std::make_shared<scan_matching::HillClimbing>(hill_climbing, EndpointOptionsFromFlags());
}

scan_matching::EndpointModel::Options EndpointOptionsFromFlags() {
  return {
      .score_sigma_m = InRange("score_sigma_m", FLAGS_score_sigma_m, 1e-3, 100.0),
      .likelihood_sigma_m = InRange("likelihood_sigma_m", FLAGS_likelihood_sigma_m, 1e-3, 100.0),
      .unmatched_sigmas = InRange("unmatched_sigmas", FLAGS_unmatched_sigmas, 1e-3, 100.0),
      .likelihood_gain = InRange("likelihood_gain", FLAGS_likelihood_gain, 1e-6, 1e6),
      .unseen_is_miss = FLAGS_unseen_is_miss,
      .likelihood = OneOf<Likelihood>(
          "likelihood", FLAGS_likelihood,
          {{"surface", Likelihood::kSurface}, {"nearest_hit", Likelihood::kNearestHit}}),
      .free_cell_in_front = FLAGS_free_cell_in_front};
}

double OccupiedThresholdFromFlags() {
  return NotNegative("occupied_threshold", FLAGS_occupied_threshold);
}

}  // namespace gmapping_spa::apps
