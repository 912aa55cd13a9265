// SPDX-License-Identifier: BSD-3-Clause
// Thinning of a map's occupied cells to lines.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_THINNING_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_THINNING_H_

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Takes occupied cells away from the sides until lines of one cell are left, as connected as
// before, which share corners or edges; the cells become free. Zhang and Suen, "A fast parallel
// algorithm for thinning digital patterns", Communications of the ACM 27(3), 1984.
map::TrinaryMap Thinned(map::TrinaryMap map);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_THINNING_H_
