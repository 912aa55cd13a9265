// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/trajectory_files.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "backend/text.h"
#include "experiments/apps/input_file.h"

namespace gmapping_spa::apps {
namespace {

std::string StampsOf(const TrajectoryFile& file) {
  const auto by_stamp = [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; };
  const auto [first, last] = std::minmax_element(file.poses.begin(), file.poses.end(), by_stamp);
  return file.path + " has stamps from " + backend::FixedText(first->stamp_s, 3) + " to " +
         backend::FixedText(last->stamp_s, 3);
}

}  // namespace

TrajectoryFile ReadTrajectoryFile(const std::string& path) {
  TrajectoryFile file{path, backend::ReadTum(*OpenInput(path), path)};
  if (file.poses.empty()) throw std::runtime_error(path + ": holds no poses");
  return file;
}

std::vector<metrics::PosePair> AssociateFiles(const TrajectoryFile& truth,
                                              const TrajectoryFile& estimate, double max_gap_s) {
  std::vector<metrics::PosePair> pairs =
      metrics::AssociateByStamp(truth.poses, estimate.poses, max_gap_s);
  if (pairs.empty()) {
    std::ostringstream message;
    message << "no pose could be associated by its stamp within " << max_gap_s
            << " s: " << StampsOf(truth) << ", " << StampsOf(estimate)
            << " (expected seconds of one clock)";
    throw std::runtime_error(message.str());
  }
  return pairs;
}

}  // namespace gmapping_spa::apps
