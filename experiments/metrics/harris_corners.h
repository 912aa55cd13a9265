// SPDX-License-Identifier: BSD-3-Clause
// Corners of what is occupied in a map.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_HARRIS_CORNERS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_HARRIS_CORNERS_H_

#include <Eigen/Core>
#include <vector>

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Where Harris' measure det(M) - 0.04 trace(M)^2, with the derivatives of Sobel summed over 5 x 5
// cells, is larger than `min_share` of what the corner of a wide wall has and not smaller than
// anywhere within three cells: centres of cells in the frame of the map, by rows and columns.
// Corners closer than two cells to the edge of the map are not found; closing.h has a frame.
std::vector<Eigen::Vector2d> FindCorners(const map::TrinaryMap& map, double min_share);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_HARRIS_CORNERS_H_
