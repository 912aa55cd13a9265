// SPDX-License-Identifier: BSD-3-Clause
// A particle filter on a drive around a synthetic room.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_TOUR_H_
#define GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_TOUR_H_

#include <cmath>
#include <memory>
#include <vector>

#include "frontend/particle_filter/particle_filter.h"
#include "frontend/scan_matching/hill_climbing.h"
#include "tests/frontend/particle_filter/same_map.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::particle_filter {

// Once around the room, half a metre or so at a time; starts at the origin.
inline std::vector<backend::SE2> Drive() {
  std::vector<backend::SE2> world_T_robot = {{}};
  for (int i = 0; i < 20; ++i) {
    world_T_robot.push_back(world_T_robot.back() *
                            backend::SE2{0.4, 0.02, 2.0 * std::acos(-1.0) / 20});
  }
  return world_T_robot;
}

// What the odometry claims: too short, and turning too little.
inline backend::SE2 MeasuredIncrement(const backend::SE2& from, const backend::SE2& to) {
  const backend::SE2 increment = Between(from, to);
  return {0.95 * increment.x, increment.y, 0.97 * increment.theta};
}

inline sensor::LaserScan ScanOnDrive(int step) {
  return synthetic::Scan(synthetic::Room(), Drive()[step]);
}

struct Tour {
  // The first `steps` of the drive.
  explicit Tour(const ParticleFilter::Options& options, int steps = 20)
      : filter(options, std::make_shared<scan_matching::HillClimbing>(
                            scan_matching::HillClimbing::Options{}, options.endpoint)) {
    filter.Start(ScanOnDrive(0), Drive()[0]);
    Continue(steps);
  }

  void Continue(int steps) {
    const std::vector<backend::SE2> truth = Drive();
    for (; steps > 0; --steps) {
      const std::size_t i = updates.size() + 1;
      updates.push_back(filter.Update(ScanOnDrive(static_cast<int>(i)),
                                      {{MeasuredIncrement(truth[i - 1], truth[i])}}));
    }
  }

  ParticleFilter filter;
  std::vector<ParticleFilter::UpdateResult> updates;
};

inline ParticleFilter::Options Particles(int particles, int threads = 1, std::uint64_t seed = 1) {
  ParticleFilter::Options options;
  options.particles = particles;
  options.threads = threads;
  options.seed = seed;
  options.match_start.guesses = 5;
  options.edges.measurement = EdgeModel::Measurement::kParticle;
  options.resample_threshold = 0.9;  // so that it happens
  return options;
}

inline bool SamePoses(const ParticleFilter& a, const ParticleFilter& b) {
  for (std::size_t i = 0; i < a.particles().size(); ++i) {
    const int k = static_cast<int>(i);
    if (PosesOf(a.Path(k)) != PosesOf(b.Path(k))) return false;
    if (a.particles()[i].log_weight != b.particles()[i].log_weight) return false;
    if (a.particles()[i].log_likelihood != b.particles()[i].log_likelihood) return false;
  }
  return true;
}

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_TOUR_H_
