// SPDX-License-Identifier: BSD-3-Clause
// From rows of a table to closures of a run.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_EDITS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_EDITS_H_

#include <string>
#include <vector>

#include "experiments/apps/closure_rows.h"
#include "experiments/apps/json.h"
#include "frontend/improved_gmapping.h"

namespace gmapping_spa::apps {

// Of a closure that came without its information.
inline constexpr double kDefaultSigma_m = 0.05;
inline constexpr double kDefaultSigma_rad = 0.02;

// Makes the closures of `gmapping` those of the rows, once what is missing is there: a pose is
// measured by the scans of the two nodes, where those of all rows that have one put them; for
// information there is a default, which is warned of once. Returns the numbers of rows by what was
// changed. Throws std::runtime_error "<name>:<line>: ..." when the scans of a row without a pose do
// not fit.
Json ApplyClosureRows(std::vector<ClosureRow> rows, const std::string& name,
                      frontend::ImprovedGmapping* gmapping);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_EDITS_H_
