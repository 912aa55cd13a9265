// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/relations.h"

#include <optional>
#include <sstream>
#include <stdexcept>

#include "backend/graph/number_rows.h"
#include "backend/text.h"
#include "experiments/metrics/angles.h"
#include "experiments/metrics/association.h"

namespace gmapping_spa::metrics {

using backend::FixedText;
using backend::SE2;

std::vector<Relation> ReadRelations(std::istream& in, const std::string& name) {
  backend::NumberRows rows(in, name, "t1 t2 x y z roll pitch yaw");
  std::vector<Relation> relations;
  while (rows.Next()) {
    const std::vector<double>& v = rows.row();
    relations.push_back({v[0], v[1], {v[2], v[3], v[7]}});
  }
  return relations;
}

RelationsSummary EvaluateRelations(const std::vector<Relation>& relations,
                                   const backend::Trajectory& trajectory,
                                   const RelationsOptions& options) {
  const backend::Trajectory sorted = SortedByStamp(trajectory);
  std::vector<double> translations_m, rotations_deg;
  for (const Relation& relation : relations) {
    const std::optional<SE2> world_T_i = PoseAt(sorted, relation.stamp_i_s, options.max_gap_s);
    const std::optional<SE2> world_T_j = PoseAt(sorted, relation.stamp_j_s, options.max_gap_s);
    if (!world_T_i || !world_T_j) continue;
    const SE2 error = backend::Between(relation.i_T_j, backend::Between(*world_T_i, *world_T_j));
    translations_m.push_back(error.translation().norm());
    rotations_deg.push_back(AbsDegrees(error.theta));
  }
  if (translations_m.empty()) {
    std::ostringstream message;
    message << "none of the " << relations.size() << " relations has both stamps within "
            << options.max_gap_s << " s of one of the " << trajectory.size()
            << " stamps of the trajectory";
    if (!relations.empty() && !sorted.empty()) {
      message << ": the first relation is from " << FixedText(relations.front().stamp_i_s, 3)
              << " to " << FixedText(relations.front().stamp_j_s, 3) << ", the trajectory from "
              << FixedText(sorted.front().stamp_s, 3) << " to "
              << FixedText(sorted.back().stamp_s, 3) << " (expected seconds of one clock)";
    }
    throw std::runtime_error(message.str());
  }
  return {.used = static_cast<int>(translations_m.size()),
          .not_associated = static_cast<int>(relations.size() - translations_m.size()),
          .translation_m = ComputeStatistics(translations_m),
          .rotation_deg = ComputeStatistics(rotations_deg)};
}

}  // namespace gmapping_spa::metrics
