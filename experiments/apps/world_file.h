// SPDX-License-Identifier: BSD-3-Clause
// World files: six lines that tell GIS programs where a picture lies.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_WORLD_FILE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_WORLD_FILE_H_

#include <ostream>

namespace gmapping_spa::apps {

// Where a picture lies in the world frame: the side of a pixel and the upper left corner.
struct PicturePlace {
  double pixel_m;
  double left_x_m;
  double top_y_m;
};

// Writes the format of ESRI: x per column, y per column, x per row, y per row, and the center of
// the upper left pixel.
void WriteWorldFile(const PicturePlace& place, std::ostream& out);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_WORLD_FILE_H_
