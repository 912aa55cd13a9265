// SPDX-License-Identifier: BSD-3-Clause
// A table of loop closures (closure_table.h) that somebody has edited.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_ROWS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_ROWS_H_

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "frontend/loop_closure/closure_record.h"

namespace gmapping_spa::apps {

struct ClosureRow {
  // Against what the program found.
  enum class Change : std::uint8_t { kNone, kAccepted, kRejected, kAdded };

  int line = 0;
  Change change = Change::kNone;
  loop_closure::ClosureRecord record;
  bool has_pose = false;
  bool has_information = false;
};

// Reads the columns that the first line names, in any order: old_node, node and verdict must be
// there; x_m, y_m, theta_rad, I11, I12, I13, I22, I23, I33, source and found may be; others are not
// read. `verdict` is "accepted" or "accept", "rejected" or "reject", "add", or left as it was. A
// row without `found` is new: an accepted one is added, with its pose or without. Where there is no
// column `found`, nothing but rows of the verdict "add" is known to be changed.
//
// Nodes are 0 ... nodes - 1, the old one first. Throws std::runtime_error "<name>:<line>: expected
// <what>, found <what>" on other words, numbers that are none or not finite, half a pose, an
// information matrix that is not positive definite, nodes that do not exist, two accepted rows of
// the same nodes, and an accepted row of the program's without a pose.
std::vector<ClosureRow> ReadClosureRows(std::istream& in, const std::string& name, int nodes);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_CLOSURE_ROWS_H_
