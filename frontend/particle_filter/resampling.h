// SPDX-License-Identifier: BSD-3-Clause
// Importance weights and selective resampling.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_RESAMPLING_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_RESAMPLING_H_

#include <vector>

namespace gmapping_spa::particle_filter {

// exp(gain * log_weights), normalized to sum 1. A gain below 1 flattens the weights: the beams of a
// scan are not as independent as their product takes them.
std::vector<double> NormalizedWeights(const std::vector<double>& log_weights, double gain);

// Of step 9: N_eff = 1 / sum w^2, between 1 and the number of particles.
double EffectiveSampleSize(const std::vector<double>& weights);

// Eq. (17), as systematic resampling: `count` draws N, ascending, index i floor(N w_i) or ceil(N
// w_i) times. `uniform` in [0, 1) is the only random number.
std::vector<int> SystematicResample(const std::vector<double>& weights, int count, double uniform);

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_RESAMPLING_H_
