// SPDX-License-Identifier: BSD-3-Clause
// Trajectories from files, with errors that name the files.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_TRAJECTORY_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_TRAJECTORY_FILES_H_

#include <string>
#include <vector>

#include "backend/enum_names.h"
#include "backend/graph/trajectory_io.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/trajectory_error.h"

namespace gmapping_spa::apps {

struct TrajectoryFile {
  std::string path;
  backend::Trajectory poses;
  bool has_stamps = true;
};

// What --align of the programs that compare trajectories stands for.
inline constexpr backend::EnumName<metrics::Alignment> kAlignments[] = {
    {"first", metrics::Alignment::kFirst},
    {"none", metrics::Alignment::kNone},
    {"se2", metrics::Alignment::kSe2}};

// Reads a file of the TUM format, plain or gzipped. Throws std::runtime_error with one line when it
// cannot be read or holds no poses.
TrajectoryFile ReadTrajectoryFile(const std::string& path);

// Likewise the TUM or the KITTI format: the number of columns of the first pose tells. Poses of
// KITTI have no stamps; their numbers stand for them.
TrajectoryFile ReadTumOrKittiFile(const std::string& path);

// Pairs of poses whose stamps differ by max_gap_s at most; of two files without stamps, poses of
// the same number. Throws std::runtime_error with one line when those have different numbers of
// poses, or one of the files has stamps and the other one not. Throws std::runtime_error with one
// line, which tells the stamps of both files, when there is none.
std::vector<metrics::PosePair> AssociateFiles(const TrajectoryFile& truth,
                                              const TrajectoryFile& estimate, double max_gap_s);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_TRAJECTORY_FILES_H_
