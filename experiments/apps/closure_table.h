// SPDX-License-Identifier: BSD-3-Clause
// Loop closures as a table.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_TABLE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_TABLE_H_

#include <ostream>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "experiments/apps/json.h"
#include "frontend/loop_closure/closure_record.h"

namespace gmapping_spa::apps {

// Comma-separated values with a header: a line for every candidate that was looked at. `found` is
// what the program says of it, `verdict` what counts: they differ where somebody knew better
// (closure_rows.h). I11 ... I33 is the information of x_m, y_m, theta_rad, in the order of .g2o.
void WriteClosures(const std::vector<loop_closure::ClosureRecord>& records,
                   const std::vector<backend::Node>& nodes, std::ostream& out);

// Number of candidates by what became of them.
Json CountClosures(const std::vector<loop_closure::ClosureRecord>& records);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_TABLE_H_
