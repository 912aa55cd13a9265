// SPDX-License-Identifier: BSD-3-Clause
// Where in a known map a robot was, scan by scan, as a CSV file.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_LOCALIZATION_TABLE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_LOCALIZATION_TABLE_H_

#include <ostream>
#include <vector>

#include "backend/plugin/optimizer.h"
#include "frontend/improved_gmapping.h"
#include "frontend/slam_result.h"

namespace gmapping_spa::apps {

struct LocalizedScan {
  backend::StampedPose pose;  // map_T_robot; of no meaning where it is not known
  bool is_known = false;
  // Of (x, y, theta), m and rad, x and y along the axes of the map.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

// The scans of the session of `gmapping`, whose final result is `result`. Covariances are those of
// the graph with the nodes of the old map held: of the node at or before the scan, moved along to
// the scan. Throws like backend::Covariances.
std::vector<LocalizedScan> LocalizedScans(const frontend::ImprovedGmapping& gmapping,
                                          const frontend::SlamResult& result,
                                          backend::Optimizer* optimizer);

// A line of names, a line for each scan; where the pose is not known it and its covariance are
// empty. Numbers read back as they are.
void WriteLocalization(const std::vector<LocalizedScan>& scans, std::ostream& out);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_LOCALIZATION_TABLE_H_
