// SPDX-License-Identifier: BSD-3-Clause
// Loop closures as a table.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_TABLE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_TABLE_H_

#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "experiments/apps/json.h"
#include "frontend/loop_closure/closure_record.h"

namespace gmapping_spa::apps {

// Comma-separated values with a header: a line for every candidate that was looked at.
void WriteClosures(const std::vector<loop_closure::ClosureRecord>& records,
                   const std::vector<backend::Node>& nodes, std::ostream& out);

// The candidates of such a table, without their information. `nodes` is the number of nodes of the
// graph. Throws std::runtime_error "<name>:<line>: expected <what>, found <what>".
std::vector<loop_closure::ClosureRecord> ReadClosures(std::istream& in, const std::string& name,
                                                      std::size_t nodes);

// Number of candidates by what became of them.
Json CountClosures(const std::vector<loop_closure::ClosureRecord>& records);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_TABLE_H_
