// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2. Eigen has another name here: else the linker would take
// functions of it that these instructions are in for those of other sources.
#if defined(__x86_64__)
#define Eigen EigenForAvx2
#define GMAPPING_SPA_KERNELS avx2
#include "backend/sparse/dense_front_kernels.h"
#endif
