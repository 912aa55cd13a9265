// SPDX-License-Identifier: BSD-3-Clause
// What became of an optimization.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_OPTIMIZATION_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_OPTIMIZATION_H_

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::python {

struct Optimization {
  backend::Loss loss;  // that it was under
  backend::Summary summary;
};

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_OPTIMIZATION_H_
