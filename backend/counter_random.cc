// SPDX-License-Identifier: BSD-3-Clause
#include "backend/counter_random.h"

#include <Random123/philox.h>

#include <Random123/boxmuller.hpp>
#include <Random123/uniform.hpp>
#include <cmath>

namespace gmapping_spa::backend {

CounterRandom::Words CounterRandom::NextBlock() {
  const r123::Philox4x32::key_type key = {
      {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)}};
  const r123::Philox4x32::ctr_type counter = {{block_++, stream_, a_, b_}};
  const r123::Philox4x32::ctr_type random = r123::Philox4x32()(counter, key);
  return {random[0] | std::uint64_t{random[1]} << 32, random[2] | std::uint64_t{random[3]} << 32};
}

double CounterRandom::Uniform() { return r123::u01fixedpt<double>(NextBlock().first); }

double CounterRandom::Gaussian() {
  double result = spare_gaussian_;
  spare_gaussian_ = std::numeric_limits<double>::quiet_NaN();
  if (std::isnan(result)) {
    const Words words = NextBlock();
    const r123::double2 pair = r123::boxmuller(words.first, words.second);
    result = pair.x;
    spare_gaussian_ = pair.y;
  }
  return result;
}

}  // namespace gmapping_spa::backend
