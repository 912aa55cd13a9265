// SPDX-License-Identifier: BSD-3-Clause
// The Rao-Blackwellized particle filter of GMapping: each particle a trajectory and its map.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARTICLE_FILTER_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARTICLE_FILTER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/map/scan_insertion.h"
#include "frontend/particle_filter/control.h"
#include "frontend/particle_filter/edge_model.h"
#include "frontend/particle_filter/map_history.h"
#include "frontend/particle_filter/match_start.h"
#include "frontend/particle_filter/motion_model.h"
#include "frontend/particle_filter/particle.h"
#include "frontend/particle_filter/path_correction.h"
#include "frontend/particle_filter/pose_sampling.h"
#include "frontend/particle_filter/trajectory_tree.h"
#include "frontend/scan_matching/endpoint_model.h"
#include "frontend/scan_matching/scan_matcher.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::particle_filter {

// Rao-Blackwellized: of p(x_1:t, m | z, u) = p(m | x_1:t, z) p(x_1:t | z, u), the particles sample
// the second factor, and the first one is computed for each of them (Grisetti et al. 2007).
class ParticleFilter {
 public:
  struct Options {
    int particles = 5;
    int threads = 1;
    std::uint64_t seed = 1;
    // Resampling when N_eff falls below this part of the number of particles.
    double resample_threshold = 0.5;
    MatchStart::Options match_start;
    PoseSampling::Kind proposal = PoseSampling::Kind::kGaussian;
    // Weights are p(z)^(1 / (gain * particles)), as in GMapping.
    double obs_sigma_gain = 1.0;
    EdgeModel::Options edges;
    MotionModel::Options motion;
    map::OccupancyGrid::Options grid;
    map::InsertionOptions insertion;
    MapHistory::Options map_history;
    scan_matching::EndpointModel::Options endpoint;
    friend bool operator==(const Options&, const Options&) = default;
  };

  using Control = particle_filter::Control;

  struct UpdateResult {
    double effective_sample_size = 0.0;
    bool resampled = false;
    int failed_matches = 0;  // number of particles
  };

  struct Times {  // wall clock, s
    double matching_s = 0.0;
    double registration_s = 0.0;
    double resampling_s = 0.0;
    double correction_s = 0.0;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(matching_s, registration_s, resampling_s, correction_s);
    }
  };

  ParticleFilter(const Options& options, std::shared_ptr<const scan_matching::ScanMatcher> matcher);

  // Whether nothing is drawn at random, so that all particles are copies of one (but for what one
  // scan cannot decide).
  static bool AreAllAlike(const Options& options);

  // Starts all particles at `world_T_robot` with a map of this scan.
  void Start(const sensor::LaserScan& scan, const backend::SE2& world_T_robot);

  // One step of the filter. Where there is more than one control, the particles share them out in
  // proportion to their probabilities, which add up to 1: the scans to come decide.
  UpdateResult Update(const sensor::LaserScan& scan, const std::vector<Control>& controls);

  // One step of which nothing is known: `guess` is where the particles go on, each with a map of
  // this scan alone. The edge of the graph says next to nothing.
  void BeginPiece(const sensor::LaserScan& scan, const backend::SE2& guess);

  // All particles go on as copies of this one, as many as the options say.
  void KeepOnly(int particle) { Duplicate(std::vector<int>(options_.particles, particle)); }

  // Index of the particle whose whole path explains the scans best.
  int BestParticle() const;
  const std::vector<Particle>& particles() const { return particles_; }
  const Options& options() const { return options_; }

  // Poses of a particle at Start and at every Update.
  std::vector<TrajectoryTree::Vertex> Path(int particle) const;
  std::vector<backend::SE2> PosesOfPath(int particle) const;
  // The last `count` of them, the latest one first.
  std::vector<backend::SE2> LatestPoses(int particle, int count) const {
    return tree_.LatestPoses(particles_.at(particle).leaf, count);
  }

  // Step 6, eq. (14), as the paper writes it: adds the correction to each particle's current pose.
  void CorrectCurrentPoses(const PathCorrection& correction);

  // Moves the whole history of each particle and rebuilds its map. Weights and ancestry stay: the
  // correction is the same for all particles, but for what they differ in.
  void CorrectHistories(const PathCorrection& correction,
                        const MapHistory::ScanOfStep& scan_of_step);

  // Call this before a correction for which `scan_of_step` gives other scans than before.
  void ForgetMapHistory() { map_history_.Forget(); }

  const Times& times() const { return times_; }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    std::size_t count = particles_.size();
    archive(count);
    archive.Resize(
        count,
        Particle{.world_T_robot = {}, .map = map::OccupancyGrid(options_.grid), .motion = {}},
        &particles_);
    for (Particle& particle : particles_) archive(particle);
    archive(tree_, map_history_, step_, times_);
  }

 private:
  void Move(const scan_matching::ScanPoints& points, const Control& control, int index);
  std::vector<int> ChooseAncestors(UpdateResult* update);
  void Register(const sensor::LaserScan& scan, const std::vector<int>& ancestors);
  void Duplicate(const std::vector<int>& ancestors);

  Options options_;
  std::shared_ptr<const scan_matching::ScanMatcher> matcher_;
  MotionModel motion_model_;
  std::shared_ptr<const MatchStart> match_start_;
  std::shared_ptr<const PoseSampling> pose_sampling_;
  EdgeModel edge_model_;
  std::vector<Particle> particles_;
  TrajectoryTree tree_;
  MapHistory map_history_;
  std::uint32_t step_ = 0;  // addresses the random numbers
  Times times_;
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARTICLE_FILTER_H_
