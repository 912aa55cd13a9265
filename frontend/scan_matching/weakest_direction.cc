// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/weakest_direction.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace gmapping_spa::scan_matching {

WeakestDirection FindWeakestDirection(const Eigen::Matrix3d& information) {
  if (!(information(2, 2) > 0.0)) return {};
  const Eigen::Vector2d xy_theta = information.topRightCorner<2, 1>();
  const Eigen::Matrix2d given_theta =
      information.topLeftCorner<2, 2>() - xy_theta * xy_theta.transpose() / information(2, 2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(given_theta);
  return {eigen.eigenvectors().col(0), std::max(eigen.eigenvalues()[0], 0.0)};
}

}  // namespace gmapping_spa::scan_matching
