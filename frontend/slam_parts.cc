// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/slam_parts.h"

#include <utility>

#include "backend/scheduling/optimize.h"
#include "frontend/scan_matching/gauss_newton_matcher.h"
#include "frontend/scan_matching/hill_climbing.h"

namespace gmapping_spa::frontend {
namespace {

using particle_filter::EdgeModel;
using particle_filter::MatchStart;
using particle_filter::ParticleFilter;
using particle_filter::PoseSampling;
using scan_matching::EndpointModel;
using scan_matching::GaussNewton;
using scan_matching::GaussNewtonMatcher;
using scan_matching::HillClimbing;

OdometrySource SourceOf(SlamOptions::Odometry odometry) {
  switch (odometry) {
    case SlamOptions::Odometry::kRaw:
      return OdometrySource::kRaw;
    case SlamOptions::Odometry::kWheel:
      return OdometrySource::kWheel;
    case SlamOptions::Odometry::kLidar:
      return OdometrySource::kLidar;
    case SlamOptions::Odometry::kLidarOnly:
      return OdometrySource::kLidarOnly;
  }
  return {};
}

EdgeModel::Information InformationOf(SlamOptions::EdgeInformation information) {
  switch (information) {
    case SlamOptions::EdgeInformation::kProposal:
      return EdgeModel::Information::kProposal;
    case SlamOptions::EdgeInformation::kHessian:
      return EdgeModel::Information::kHessian;
    case SlamOptions::EdgeInformation::kConstant:
      return EdgeModel::Information::kConstant;
  }
  return {};
}

GraphThread::Mode ModeOf(SlamOptions::GraphThread graph_thread) {
  switch (graph_thread) {
    case SlamOptions::GraphThread::kLockstep:
      return GraphThread::Mode::kLockstep;
    case SlamOptions::GraphThread::kAsync:
      return GraphThread::Mode::kAsync;
    case SlamOptions::GraphThread::kInline:
      return GraphThread::Mode::kInline;
  }
  return {};
}

GaussNewton::Options GaussNewtonOptions(const SlamOptions& options) {
  return {.noise_sigma_m = options.match_noise_m, .robust_sigmas = options.match_robust_sigmas};
}

EndpointModel::Options EndpointOptions(const SlamOptions& options) {
  return {.score_sigma_m = options.score_sigma_m,
          .likelihood_sigma_m = options.likelihood_sigma_m,
          .unmatched_sigmas = options.unmatched_sigmas,
          .likelihood_gain = options.likelihood_gain,
          .unseen_is_miss = options.unseen_is_miss,
          .likelihood = options.likelihood == SlamOptions::Likelihood::kNearestHit
                            ? EndpointModel::Likelihood::kNearestHit
                            : EndpointModel::Likelihood::kSurface,
          .free_cell_in_front = options.free_cell_in_front};
}

EdgeModel::Options EdgeOptions(const SlamOptions& options) {
  EdgeModel::Options edges;
  const bool scans_give_motion = options.odometry == SlamOptions::Odometry::kLidar ||
                                 options.odometry == SlamOptions::Odometry::kLidarOnly;
  edges.measurement =
      scans_give_motion && options.edge_measurement == SlamOptions::EdgeMeasurement::kLidarOdometry
          ? EdgeModel::Measurement::kControl
          : EdgeModel::Measurement::kParticle;
  edges.information = InformationOf(options.edge_information);
  edges.gauss_newton = GaussNewtonOptions(options);
  return edges;
}

ParticleFilter::Options FilterOptions(const SlamOptions& options) {
  ParticleFilter::Options filter;
  filter.particles = options.particles;
  filter.threads = options.threads;
  filter.seed = options.seed;
  filter.resample_threshold = options.resample_threshold;
  filter.match_start = {.kind = options.match_start == SlamOptions::MatchStart::kDraw
                                    ? MatchStart::Kind::kDraw
                                    : MatchStart::Kind::kPrediction,
                        .guesses = options.initial_guesses};
  filter.proposal = options.proposal == SlamOptions::Proposal::kMatch
                        ? PoseSampling::Kind::kMatch
                        : PoseSampling::Kind::kGaussian;
  filter.obs_sigma_gain = options.obs_sigma_gain;
  filter.edges = EdgeOptions(options);
  filter.motion = {.linear_per_linear = options.motion_linear_per_linear,
                   .linear_per_angular = options.motion_linear_per_angular,
                   .lateral_per_linear = options.motion_lateral_per_linear,
                   .angular_per_linear = options.motion_angular_per_linear,
                   .angular_per_angular = options.motion_angular_per_angular,
                   .linear_floor_m = options.motion_linear_floor_m,
                   .angular_floor_rad = options.motion_angular_floor_rad,
                   .noise_at_each_scan = options.motion_noise == SlamOptions::MotionNoise::kScan};
  filter.grid = {.resolution_m = options.resolution_m,
                 .occupied_threshold = options.grid_occupied_threshold};
  filter.insertion.no_return_clears = options.no_return_clears;
  filter.endpoint = EndpointOptions(options);
  return filter;
}

ControlInput::Options ControlOptions(const SlamOptions& options) {
  ControlInput::Options control;
  control.source = SourceOf(options.odometry);
  control.check = {.max_speed_m_s = options.max_speed_m_s,
                   .max_turn_rad_s = options.max_turn_rad_s};
  control.lidar_odometry.gauss_newton = GaussNewtonOptions(options);
  control.lidar_odometry.grid.resolution_m = options.resolution_m;
  control.lidar_odometry.prior.max_speed_m_s = options.max_speed_m_s;
  control.lidar_odometry.prior.max_turn_rad_s = options.max_turn_rad_s;
  control.lidar_odometry.sweep_duration_s = options.sweep_duration_s;
  return control;
}

loop_closure::LoopCloser::Options CloserOptions(const SlamOptions& options) {
  loop_closure::LoopCloser::Options closer;
  closer.candidates.min_path_length_m = options.closure_min_path_length_m;
  closer.candidates.max_distance_m = options.closure_max_distance_m;
  closer.drift.m_per_m = options.closure_drift_m_per_m;
  closer.drift.rad_per_m = options.closure_drift_rad_per_m;
  closer.search_everywhere = options.closure_everywhere;
  closer.verifier.grid.resolution_m = options.resolution_m;
  closer.verifier.gauss_newton = GaussNewtonOptions(options);
  closer.verifier.search.min_score = options.closure_min_score;
  closer.verifier.max_runner_up_score = options.closure_max_runner_up_score;
  closer.verifier.min_overlap = options.closure_min_overlap;
  closer.verifier.min_inlier_ratio = options.closure_min_inlier_ratio;
  closer.verifier.information_gain = options.closure_information_gain;
  return closer;
}

}  // namespace

ImprovedGmapping::Options GmappingOptions(const SlamOptions& options) {
  ImprovedGmapping::Options gmapping;
  gmapping.linear_update_m = options.linear_update_m;
  gmapping.angular_update_rad = options.angular_update_rad;
  gmapping.filter = FilterOptions(options);
  gmapping.control = ControlOptions(options);
  gmapping.close_loops = options.loop_closure;
  gmapping.loop_closer = CloserOptions(options);
  gmapping.optimize_every = options.optimize_every;
  gmapping.graph_thread = {.mode = ModeOf(options.graph_thread),
                           .lockstep_scans = options.lockstep_scans,
                           .timeout_s = options.graph_timeout_s};
  gmapping.correction = options.correction == SlamOptions::Correction::kPose
                            ? ImprovedGmapping::Correction::kPose
                            : ImprovedGmapping::Correction::kTrajectory;
  gmapping.make_final_optimization = options.final_optimization;
  gmapping.final_optimization.refine = options.refine;
  gmapping.final_optimization.gauss_newton = GaussNewtonOptions(options);
  return gmapping;
}

std::shared_ptr<const scan_matching::ScanMatcher> MakeScanMatcher(const SlamOptions& options) {
  if (options.scan_matcher == SlamOptions::ScanMatcher::kHillClimbing) {
    return std::make_shared<HillClimbing>(
        HillClimbing::Options{.linear_step_m = options.match_linear_step_m,
                              .angular_step_rad = options.match_angular_step_rad,
                              .num_refinements = options.match_refinements,
                              .min_score = options.match_min_score},
        EndpointOptions(options));
  }
  return std::make_shared<GaussNewtonMatcher>(
      GaussNewtonMatcher::Options{.alignment = GaussNewtonOptions(options),
                                  .min_score = options.match_min_score},
      EndpointOptions(options));
}

GraphThread::OptimizeFunction BindOptimizer(const SlamOptions& options,
                                            std::shared_ptr<backend::Optimizer> optimizer) {
  return [graduated = options.gnc, how = options.optimizer,
          optimizer = std::move(optimizer)](backend::PoseGraph* graph) {
    return backend::Optimize(how, graduated, optimizer.get(), graph);
  };
}

}  // namespace gmapping_spa::frontend
