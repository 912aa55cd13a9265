// SPDX-License-Identifier: BSD-3-Clause
#define GMAPPING_SPA_KERNELS any_processor
#include "backend/sparse/dense_front_kernels.h"

namespace gmapping_spa::spa {

#if defined(__x86_64__)
namespace avx2 {
extern const DenseFront kDenseFront;
}
#endif

const DenseFront& DenseFrontForThisProcessor() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2::kDenseFront;
#endif
  return any_processor::kDenseFront;
}

}  // namespace gmapping_spa::spa
