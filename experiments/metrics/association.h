// SPDX-License-Identifier: BSD-3-Clause
// Which poses of two recordings belong to the same moment.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_ASSOCIATION_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_ASSOCIATION_H_

#include <optional>
#include <vector>

#include "backend/graph/trajectory_io.h"

namespace gmapping_spa::metrics {

// The trajectory in the order of its stamps; poses of equal stamp keep their order.
backend::Trajectory SortedByStamp(backend::Trajectory trajectory);

// The pose at a stamp. A pose with exactly that stamp is returned as it is (the first one, if there
// are several). Otherwise the nearest stamp must not be further away than `max_gap_s`, and the pose
// is interpolated between the neighbors in time by a motion of constant body velocity; before the
// first and after the last stamp it is the first or last pose. Nothing if no stamp is that near.
// `trajectory` must be sorted by stamp.
std::optional<backend::SE2> PoseAt(const backend::Trajectory& trajectory, double stamp_s,
                                   double max_gap_s);

// Poses of the same moment in two world frames.
struct PosePair {
  double stamp_s = 0.0;  // of the estimate
  backend::SE2 truth_T_robot;
  backend::SE2 estimate_T_robot;
};

// Pairs each pose of the trajectory with fewer poses (the estimate, if they have as many) with the
// pose of the other one that is nearest in time, the earlier of two as near; without a pair stay
// those that have none within `max_gap_s`. In the order of stamps.
std::vector<PosePair> AssociateByStamp(const backend::Trajectory& truth,
                                       const backend::Trajectory& estimate, double max_gap_s);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_ASSOCIATION_H_
