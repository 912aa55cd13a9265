// The surface that a beam met, from the hit means of a map near its end point.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LOCAL_SURFACE_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LOCAL_SURFACE_H_

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

#include "frontend/map/cell_block.h"
#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::scan_matching {

// The hit means near a point summed up as a Gaussian, weighted by a window around the point: a
// moving least squares surface. Its distance is long across a wall and short along it, so that a
// scan may slide along a corridor; the nearest hit mean alone would hold it by the spacing of
// cells. In cells.
struct LocalSurface {
  Eigen::Vector2f offset;      // from the point to the weighted mean
  Eigen::Matrix2f covariance;  // of the means

  // Sums up the full cells of the 3 x 3 neighbourhood of the cell `index`, which holds the point
  // (x, y). False when there are none.
  bool Fit(const map::CellBlock& block, map::CellIndex index, double x, double y) {
    const Eigen::Vector2f point(static_cast<float>(x - index.x), static_cast<float>(y - index.y));
    float sum = 0.0f;
    Eigen::Vector2f first = Eigen::Vector2f::Zero();
    Eigen::Matrix2f second = Eigen::Matrix2f::Zero();
    block.ForEachFullNeighbour(index, 0, 0, [&](float mean_x, float mean_y) {
      const Eigen::Vector2f d = Eigen::Vector2f(mean_x, mean_y) - point;
      // Falls to 0 at two cells, where hit means drop out of the neighbourhood.
      const float root = std::max(0.0f, 1.0f - 0.25f * d.squaredNorm());
      const float weight = root * root;
      sum += weight;
      first += weight * d;
      second += weight * d * d.transpose();
    });
    if (sum <= 0.0f) return false;
    offset = first / sum;
    covariance = second / sum - offset * offset.transpose();
    return true;
  }

  // Inverse of the covariance widened by the noise of a hit.
  Eigen::Matrix2f Information(float noise_sigma_cells) const {
    return (covariance + noise_sigma_cells * noise_sigma_cells * Eigen::Matrix2f::Identity())
        .inverse();
  }
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LOCAL_SURFACE_H_
