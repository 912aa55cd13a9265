// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/closure_edits.h"

#include <glog/logging.h>

#include <algorithm>
#include <stdexcept>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::apps {
namespace {

using loop_closure::ClosureRecord;
using loop_closure::Verdict;

bool IsToBeMeasured(const ClosureRow& row) {
  return row.record.verdict == Verdict::kAccepted && !row.has_pose;
}

std::vector<ClosureRecord> RecordsOf(const std::vector<ClosureRow>& rows) {
  std::vector<ClosureRecord> records;
  for (const ClosureRow& row : rows) {
    if (!IsToBeMeasured(row)) records.push_back(row.record);
  }
  return records;
}

int FillInformation(std::vector<ClosureRow>* rows) {
  int count = 0;
  for (ClosureRow& row : *rows) {
    if (row.record.verdict != Verdict::kAccepted || row.has_information || !row.has_pose) continue;
    row.record.information = backend::InformationFromSigmas(kDefaultSigma_m, kDefaultSigma_rad);
    ++count;
  }
  LOG_IF(WARNING, count > 0) << count << " closures have no information (I11 ... I33): taken for "
                             << kDefaultSigma_m << " m and " << kDefaultSigma_rad << " rad";
  return count;
}

ClosureRecord Measured(const ClosureRow& row, const std::string& name,
                       const std::vector<backend::SE2>& world_T_nodes,
                       const frontend::ImprovedGmapping& gmapping) {
  ClosureRecord record =
      gmapping.MeasureClosure(world_T_nodes, row.record.old_node, row.record.node);
  // That the map has other places like it does not matter: somebody says that it is this one.
  if (record.verdict != Verdict::kUnconfirmed && record.verdict != Verdict::kRival) {
    throw std::runtime_error(name + ":" + std::to_string(row.line) +
                             ": expected nodes whose scans fit, or their pose as x_m, y_m, "
                             "theta_rad, found " +
                             loop_closure::VerdictName(record.verdict));
  }
  record.verdict = Verdict::kAccepted;
  record.is_by_hand = true;
  return record;
}

}  // namespace

Json ApplyClosureRows(std::vector<ClosureRow> rows, const std::string& name,
                      frontend::ImprovedGmapping* gmapping) {
  const int without_information = FillInformation(&rows);
  const int taken_out = gmapping->EditClosures(RecordsOf(rows));
  LOG_IF(WARNING, taken_out > 0)
      << name << ": " << taken_out
      << " accepted closures have no row any more: they are rejected by hand";
  int measured = 0;
  if (std::ranges::any_of(rows, IsToBeMeasured)) {
    const std::vector<backend::SE2> world_T_nodes = gmapping->OptimizedNodes();
    for (ClosureRow& row : rows) {
      if (!IsToBeMeasured(row)) continue;
      row.record = Measured(row, name, world_T_nodes, *gmapping);
      row.has_pose = true;
      ++measured;
    }
    gmapping->EditClosures(RecordsOf(rows));
  }
  const auto count = [&rows](ClosureRow::Change change) {
    return std::ranges::count(rows, change, &ClosureRow::change);
  };
  using Change = ClosureRow::Change;
  return {{"rows", rows.size()},
          {"unchanged", count(Change::kNone)},
          {"accepted", count(Change::kAccepted)},
          {"rejected", count(Change::kRejected)},
          {"added", count(Change::kAdded)},
          {"taken_out", taken_out},
          {"measured", measured},
          {"default_information", without_information}};
}

}  // namespace gmapping_spa::apps
