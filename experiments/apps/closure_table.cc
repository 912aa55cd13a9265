// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/closure_table.h"

#include <iomanip>

#include "backend/text.h"

namespace gmapping_spa::apps {

void WriteClosures(const std::vector<loop_closure::ClosureRecord>& records,
                   const std::vector<backend::Node>& nodes, std::ostream& out) {
  out << "old_node,node,old_stamp_s,stamp_s,path_length_m,distance_m,score,runner_up_score,overlap,"
         "inlier_ratio,"
         "mutual_inlier_ratio,mahalanobis_sq,x_m,y_m,theta_rad,I11,I12,I13,I22,I23,I33,source,"
         "found,"
         "verdict\n";
  for (const loop_closure::ClosureRecord& record : records) {
    const backend::SE2& pose = record.old_T_node;
    out << std::fixed << record.old_node << ',' << record.node << ',' << std::setprecision(6)
        << nodes.at(record.old_node).stamp_s << ',' << nodes.at(record.node).stamp_s << ','
        << std::setprecision(3) << record.path_length_m << ',' << record.distance_m << ','
        << record.score << ',' << record.runner_up_score << ',' << record.overlap << ','
        << record.inlier_ratio << ',' << record.mutual_inlier_ratio << ',' << record.mahalanobis_sq;
    for (const double number : {pose.x, pose.y, pose.theta}) {
      out << ',' << backend::ShortestText(number);
    }
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) {
        out << ',' << backend::ShortestText(record.information(row, column));
      }
    }
    const bool is_found = record.source != loop_closure::Source::kHand;
    const auto found = record.is_by_hand ? record.overruled_verdict : record.verdict;
    out << ',' << loop_closure::SourceName(record.source) << ','
        << (is_found ? loop_closure::VerdictName(found) : "") << ','
        << loop_closure::VerdictName(record.verdict) << '\n';
  }
}

Json CountClosures(const std::vector<loop_closure::ClosureRecord>& records) {
  Json counts = {{"candidates", records.size()}, {"accepted", 0}};
  Json& rejected = counts["rejected"] = Json::object();
  for (const loop_closure::ClosureRecord& record : records) {
    if (record.verdict == loop_closure::Verdict::kAccepted) {
      counts["accepted"] = counts["accepted"].get<int>() + 1;
    } else {
      const char* reason = loop_closure::VerdictName(record.verdict);
      rejected[reason] = rejected.value(reason, 0) + 1;
    }
  }
  return counts;
}

}  // namespace gmapping_spa::apps
