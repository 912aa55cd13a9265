// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/trajectory_files.h"

#include <algorithm>
#include <istream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "backend/graph/kitti_io.h"
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

constexpr std::size_t kKittiColumns = 12;

// Of the first line that is neither blank nor a comment; 0 without one.
std::size_t ColumnsOf(const std::string& path) {
  const std::unique_ptr<std::istream> in = OpenInput(path);
  bool is_first = true;
  for (std::string line; std::getline(*in, line); is_first = false) {
    const std::string_view text = is_first ? backend::WithoutByteOrderMark(line) : line;
    const std::size_t columns = backend::WordsOf(backend::WithoutComment(text)).size();
    if (columns > 0) return columns;
  }
  return 0;
}

}  // namespace

TrajectoryFile ReadTrajectoryFile(const std::string& path) {
  TrajectoryFile file{path, backend::ReadTum(*OpenInput(path), path)};
  if (file.poses.empty()) throw std::runtime_error(path + ": holds no poses");
  return file;
}

TrajectoryFile ReadTumOrKittiFile(const std::string& path) {
  if (ColumnsOf(path) != kKittiColumns) return ReadTrajectoryFile(path);
  TrajectoryFile file{path, {}, /*has_stamps=*/false};
  for (const backend::SE2& pose : backend::ReadKitti(*OpenInput(path), path)) {
    file.poses.push_back({static_cast<double>(file.poses.size()), pose});
  }
  return file;
}

std::vector<metrics::PosePair> AssociateFiles(const TrajectoryFile& truth,
                                              const TrajectoryFile& estimate, double max_gap_s) {
  if (truth.has_stamps != estimate.has_stamps) {
    const TrajectoryFile& without = truth.has_stamps ? estimate : truth;
    const TrajectoryFile& with = truth.has_stamps ? truth : estimate;
    throw std::runtime_error(without.path + ": has no stamps (KITTI), and " + with.path +
                             " has (TUM): expected two files of one format");
  }
  if (!truth.has_stamps && truth.poses.size() != estimate.poses.size()) {
    throw std::runtime_error(estimate.path + ": expected as many poses as in " + truth.path + ", " +
                             std::to_string(truth.poses.size()) +
                             ", as they have no stamps, found " +
                             std::to_string(estimate.poses.size()));
  }
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
