// SPDX-License-Identifier: BSD-3-Clause
// The part of the world that a picture shows.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_PICTURE_VIEW_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_PICTURE_VIEW_H_

#include <algorithm>
#include <cmath>

namespace gmapping_spa::apps {

// The part of the world that is shown, in its frame, and how it is mapped to pixels.
struct PictureView {
  double min_x_m, min_y_m, max_x_m, max_y_m;
  double pixels_per_m;

  double Column(double x_m) const { return (x_m - min_x_m) * pixels_per_m; }
  double Row(double y_m) const { return (max_y_m - y_m) * pixels_per_m; }
  int width_px() const { return std::max(1, static_cast<int>(std::lround(Column(max_x_m)))); }
  int height_px() const { return std::max(1, static_cast<int>(std::lround(Row(min_y_m)))); }
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_PICTURE_VIEW_H_
