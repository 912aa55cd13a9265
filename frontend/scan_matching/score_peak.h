// SPDX-License-Identifier: BSD-3-Clause
// The peak of the scores of correlative scan matching around the best pose.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCORE_PEAK_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCORE_PEAK_H_

#include <Eigen/Core>

#include "frontend/scan_matching/pose_lattice.h"

namespace gmapping_spa::scan_matching {

// The poses that count as the same match as the best one: no more than a separation away from it in
// position and in angle.
class ScorePeak {
 public:
  // `lattice` must outlive this.
  ScorePeak(const PoseLattice* lattice, const PoseBlock& best, double separation_m,
            double separation_rad);

  bool HoldsAllOf(const PoseBlock& block) const;
  bool HoldsSomeOf(const PoseBlock& block) const;

  // Second moments about the best pose of (x, y, theta) in the frame of the map, in m and rad, over
  // the poses of the peak with weights exp(log_weight_per_sum (sum(pose) - sum(best))), and those
  // of rounding to the lattice. Of Olson, "Real-time correlative scan matching" (ICRA 2009), but
  // for the weights and for the moments about the best pose instead of the mean.
  Eigen::Matrix3d Covariance(double log_weight_per_sum) const;

 private:
  // Whether the peak holds the offset that choose(first, last) picks, in each dimension, from the
  // offsets of the block.
  template <typename Choose>
  bool HoldsOffset(const PoseBlock& block, const Choose& choose) const;

  const PoseLattice* lattice_;
  PoseBlock best_;
  double squared_radius_;  // in cells
  double separation_rad_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCORE_PEAK_H_
