// SPDX-License-Identifier: BSD-3-Clause
// Purposes of the simulator's random numbers: see backend/counter_random.h.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_RANDOM_STREAMS_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_RANDOM_STREAMS_H_

#include <cstdint>

namespace gmapping_spa::simulation {

// Far from small numbers, so that a filter run with the simulator's seed draws others.
enum RandomStream : std::uint32_t {
  kLidarStream = 0x51d00001,     // a: scan, b: beam
  kOdometryStream = 0x51d00002,  // a: step
  kSlipStream = 0x51d00003,      // a: step
  kBumpStream = 0x51d00004,      // a: step
  kBiasStream = 0x51d00005,
  kCrowdStream = 0x51d00006,  // a: step, b: walker
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_RANDOM_STREAMS_H_
