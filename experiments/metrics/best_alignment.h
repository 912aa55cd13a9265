// SPDX-License-Identifier: BSD-3-Clause
// Where most of a map fits the true one.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_BEST_ALIGNMENT_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_BEST_ALIGNMENT_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// The motion that lays the frame of the map over that of the truth such that most of its occupied
// cells lie on the true map's: the best of the candidates, each of them moved and turned as long as
// it gets better. A cell counts less the farther off it is, and not at all beyond 0.25 m: parts of
// the map that do not fit leave the rest where it is, which a least square does not. The first
// candidate when the map is empty; throws std::invalid_argument when there is none.
backend::SE2 FindBestAlignment(const map::TrinaryMap& truth, const map::TrinaryMap& map,
                               const std::vector<backend::SE2>& candidates);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_BEST_ALIGNMENT_H_
