// SPDX-License-Identifier: BSD-3-Clause
// The surface that a beam met, from the hit means of a map near its end point.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LOCAL_SURFACE_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LOCAL_SURFACE_H_

#include <Eigen/Core>
#include <Eigen/LU>

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

  // Sums up the occupied cells of the 3 x 3 neighborhood of the cell `index`, which holds the point
  // (x, y). False when there are none.
  bool Fit(const map::CellBlock& block, map::CellIndex index, double x, double y) {
    if (!block.HasOccupiedNeighbor(index)) return false;
    const auto in_cell_x = static_cast<float>(x - index.x);
    const auto in_cell_y = static_cast<float>(y - index.y);
    using Eigen::Array4f;
    Array4f w = Array4f::Zero(), wx = w, wy = w, wxx = w, wxy = w, wyy = w;
    block.ForEachRowOfNeighbors(index, [&](const Array4f& mean_x, const Array4f& mean_y) {
      const Array4f dx = mean_x - in_cell_x, dy = mean_y - in_cell_y;
      // Falls to 0 at two cells, where hit means drop out of the neighborhood.
      const Array4f root = (1.0f - 0.25f * (dx * dx + dy * dy)).max(0.0f);
      const Array4f weight = root * root;
      w += weight;
      wx += weight * dx;
      wy += weight * dy;
      wxx += weight * dx * dx;
      wxy += weight * dx * dy;
      wyy += weight * dy * dy;
    });
    const float sum = w.sum();
    if (sum <= 0.0f) return false;
    const float scale = 1.0f / sum;
    offset = scale * Eigen::Vector2f(wx.sum(), wy.sum());
    const float xy = scale * wxy.sum() - offset.x() * offset.y();
    covariance << scale * wxx.sum() - offset.x() * offset.x(), xy, xy,
        scale * wyy.sum() - offset.y() * offset.y();
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
