// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/particle_filter.h"

#include <glog/logging.h>

#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "backend/graph/pose_graph.h"
#include "frontend/particle_filter/parallel_for.h"
#include "frontend/particle_filter/proposal.h"
#include "frontend/particle_filter/resampling.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::CounterRandom;
using backend::SE2;

// Streams of random numbers.
constexpr std::uint32_t kMoveStream = 1;
constexpr std::uint32_t kResampleStream = 2;

// Standard deviations of a motion of which nothing is known: enough to keep a graph in one piece.
constexpr double kUnknown_m = 1e3;
constexpr double kUnknown_rad = 1e2;

// Adds the wall-clock time of its life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double* sum_s) : sum_s_(sum_s), start_(Clock::now()) {}
  ~Stopwatch() { *sum_s_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double* sum_s_;
  Clock::time_point start_;
};

}  // namespace

ParticleFilter::ParticleFilter(const Options& options,
                               std::shared_ptr<const scan_matching::ScanMatcher> matcher)
    : options_(options),
      matcher_(std::move(matcher)),
      motion_model_(options.motion),
      match_start_(MakeMatchStart(options.match_start, motion_model_)),
      pose_sampling_(MakePoseSampling(
          options.proposal, options.edges.information == EdgeModel::Information::kProposal)),
      edge_model_(options.edges),
      map_history_(options.map_history, options.grid, options.insertion) {
  CHECK_GE(options.particles, 1);
  CHECK_GE(options.threads, 1);
  CHECK_GT(options.obs_sigma_gain, 0.0);
}

bool ParticleFilter::AreAllAlike(const Options& options) {
  return options.particles > 1 && options.proposal == PoseSampling::Kind::kMatch &&
         options.match_start.kind == MatchStart::Kind::kPrediction &&
         options.match_start.guesses == 0;
}

void ParticleFilter::Start(const sensor::LaserScan& scan, const SE2& world_T_robot) {
  Particle first{.world_T_robot = world_T_robot,
                 .map = map::OccupancyGrid(options_.grid),
                 .leaf = tree_.AddRoot(world_T_robot),
                 .motion = {}};
  map::InsertScan(scan, world_T_robot, options_.insertion, &first.map);
  particles_.assign(options_.particles, first);
}

ParticleFilter::UpdateResult ParticleFilter::Update(const sensor::LaserScan& scan,
                                                    const std::vector<Control>& controls) {
  CHECK(!particles_.empty()) << "Start comes first";
  CHECK(!controls.empty());
  ++step_;
  std::vector<double> probabilities;
  probabilities.reserve(controls.size());
  for (const Control& control : controls) probabilities.push_back(control.probability);
  // From the middle, so that a single particle takes the likeliest.
  const std::vector<int> shares = SystematicResample(probabilities, options_.particles, 0.5);
  UpdateResult update;
  {
    const Stopwatch stopwatch(&times_.matching_s);
    const scan_matching::ScanPoints points = scan_matching::MakeScanPoints(scan);
    ParallelFor(options_.threads, options_.particles,
                [&](int index) { Move(points, controls[shares[index]], index); });
  }
  for (Particle& particle : particles_) {
    update.failed_matches += particle.motion.matched ? 0 : 1;
    particle.leaf = tree_.Append(particle.leaf, particle.world_T_robot, particle.motion);
  }
  const std::vector<int> ancestors = ChooseAncestors(&update);
  {
    const Stopwatch stopwatch(&times_.registration_s);
    Register(scan, ancestors);
  }
  if (update.resampled) {
    const Stopwatch stopwatch(&times_.resampling_s);
    Duplicate(ancestors);
  }
  return update;
}

void ParticleFilter::BeginPiece(const sensor::LaserScan& scan, const SE2& guess) {
  CHECK(!particles_.empty()) << "Start comes first";
  ++step_;
  const Eigen::Matrix3d next_to_nothing = backend::InformationFromSigmas(kUnknown_m, kUnknown_rad);
  for (Particle& particle : particles_) {
    particle.world_T_robot = particle.world_T_robot * guess;
    particle.motion = {.previous_T_robot = guess, .information = next_to_nothing};
    particle.leaf = tree_.Append(particle.leaf, particle.world_T_robot, particle.motion);
    particle.map = map::OccupancyGrid(options_.grid);
    map::InsertScan(scan, particle.world_T_robot, options_.insertion, &particle.map);
  }
}

// Samples the new pose of a particle and weights it.
void ParticleFilter::Move(const scan_matching::ScanPoints& points, const Control& control,
                          int index) {
  CounterRandom random(options_.seed, kMoveStream, step_, index);
  Particle& particle = particles_[index];
  const SE2 previous = particle.world_T_robot;
  const PoseGaussian prior{previous * control.motion,  // eq. (6)
                           motion_model_.Covariance(previous, control)};
  scan_matching::EndpointModel model(options_.endpoint, &particle.map, &points);
  const SE2 start = match_start_->Choose(previous, control, &model, &random);
  const scan_matching::MatchResult match =
      matcher_->Match(particle.map, points, start, prior.covariance.inverse());  // eq. (8)
  // The log of the factor of the weight (step 5) comes with the pose.
  SampledPose sampled;
  if (match.success) {
    sampled =
        pose_sampling_->Sample(match.world_T_robot, prior, &model, &random);  // eqs. (11) to (13)
  } else {
    sampled.world_T_robot =
        match_start_->SampleInstead(start, previous, control, &random);  // eq. (9)
    sampled.log_factor = model.LogLikelihood(sampled.world_T_robot);     // eq. (10)
    sampled.world_covariance = prior.covariance;
  }
  particle.world_T_robot = sampled.world_T_robot;
  particle.motion = edge_model_.Measure(
      {previous, sampled.world_T_robot, control.motion, sampled.world_covariance, match.success},
      particle.map, points);
  particle.log_weight += sampled.log_factor;
  particle.log_likelihood += sampled.log_factor;
}

// Step 9: resamples when N_eff is small. Ancestor of each particle of the next generation.
std::vector<int> ParticleFilter::ChooseAncestors(UpdateResult* update) {
  std::vector<double> log_weights;
  for (const Particle& particle : particles_) log_weights.push_back(particle.log_weight);
  const std::vector<double> weights =
      NormalizedWeights(log_weights, 1.0 / (options_.obs_sigma_gain * options_.particles));
  update->effective_sample_size = EffectiveSampleSize(weights);
  update->resampled =
      update->effective_sample_size < options_.resample_threshold * options_.particles;
  if (update->resampled) {
    return SystematicResample(weights, options_.particles,  // eq. (17)
                              CounterRandom(options_.seed, kResampleStream, step_).Uniform());
  }
  std::vector<int> everybody(particles_.size());
  std::iota(everybody.begin(), everybody.end(), 0);
  return everybody;
}

// Enters the scan into the maps of those that live on: before they are duplicated, so that twins
// share the result.
void ParticleFilter::Register(const sensor::LaserScan& scan, const std::vector<int>& ancestors) {
  std::vector<int> survivors;
  std::unique_copy(ancestors.begin(), ancestors.end(), std::back_inserter(survivors));
  ParallelFor(options_.threads, static_cast<int>(survivors.size()), [&](int i) {
    Particle& particle = particles_[survivors[i]];
    map::InsertScan(scan, particle.world_T_robot, options_.insertion, &particle.map);
  });
}

void ParticleFilter::Duplicate(const std::vector<int>& ancestors) {
  std::vector<Particle> next;
  std::vector<TrajectoryTree::Index> leaves;
  for (const int ancestor : ancestors) {
    next.push_back(particles_[ancestor]);
    next.back().log_weight = 0.0;
    leaves.push_back(next.back().leaf);
  }
  particles_ = std::move(next);
  tree_.Prune(&leaves);
  for (std::size_t i = 0; i < leaves.size(); ++i) particles_[i].leaf = leaves[i];
}

int ParticleFilter::BestParticle() const {
  const auto best = std::max_element(
      particles_.begin(), particles_.end(),
      [](const Particle& a, const Particle& b) { return a.log_likelihood < b.log_likelihood; });
  return static_cast<int>(best - particles_.begin());
}

std::vector<TrajectoryTree::Vertex> ParticleFilter::Path(int particle) const {
  return tree_.Path(particles_[particle].leaf);
}

std::vector<SE2> ParticleFilter::PosesOfPath(int particle) const {
  return tree_.PosesOfPath(particles_[particle].leaf);
}

void ParticleFilter::CorrectCurrentPoses(const PathCorrection& correction) {
  for (Particle& particle : particles_) {
    particle.world_T_robot = correction.Apply(static_cast<int>(step_), particle.world_T_robot);
    tree_.SetPose(particle.leaf, particle.world_T_robot);
  }
}

void ParticleFilter::CorrectHistories(const PathCorrection& correction,
                                      const MapHistory::ScanOfStep& scan_of_step) {
  const Stopwatch stopwatch(&times_.correction_s);
  // Twins share leaves only right after resampling; the lineages of the dead are of no use.
  std::vector<TrajectoryTree::Index> leaves;
  for (const Particle& particle : particles_) leaves.push_back(particle.leaf);
  tree_.Prune(&leaves);
  tree_.Correct(correction);
  std::vector<map::OccupancyGrid> maps = map_history_.Rebuild(tree_, leaves, scan_of_step);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    particles_[i].leaf = leaves[i];
    particles_[i].world_T_robot = tree_.vertices()[leaves[i]].world_T_robot;
    particles_[i].map = std::move(maps[i]);
  }
}

}  // namespace gmapping_spa::particle_filter
