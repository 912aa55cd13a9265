// SPDX-License-Identifier: BSD-3-Clause
// Counter-based random numbers: each draw is a function of its address alone.
#ifndef GMAPPING_SPA_BACKEND_COUNTER_RANDOM_H_
#define GMAPPING_SPA_BACKEND_COUNTER_RANDOM_H_

#include <cstdint>
#include <limits>

namespace gmapping_spa::backend {

// A sequence of draws addressed by (seed, stream, a, b), say (the run's seed, a purpose, a scan, a
// particle). Sequences of different addresses are independent, so that results depend neither on
// the order nor on the threads in which they are drawn: there is no state to share. Making one
// costs nothing; make one where it is needed instead of keeping it.
//
// The generator is Philox4x32-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3",
// SC 2011), keyed by the seed, with the counter (block of draws, stream, a, b). Two sequences of
// the same address are equal, on every machine whose libm agrees.
class CounterRandom {
 public:
  CounterRandom(std::uint64_t seed, std::uint32_t stream, std::uint32_t a = 0, std::uint32_t b = 0)
      : seed_(seed), stream_(stream), a_(a), b_(b) {}

  // Uniform on the open interval (0, 1), in steps of 2^-52.
  double Uniform();

  // Normal with mean 0 and variance 1 (Box-Muller).
  double Gaussian();

 private:
  struct Words {
    std::uint64_t first, second;
  };
  Words NextBlock();

  std::uint64_t seed_;
  std::uint32_t stream_, a_, b_;
  std::uint32_t block_ = 0;
  // Box-Muller makes two at a time; NaN when the second one has been used up.
  double spare_gaussian_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_COUNTER_RANDOM_H_
