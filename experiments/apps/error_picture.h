// SPDX-License-Identifier: BSD-3-Clause
// The errors of a map as a picture for people.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_ERROR_PICTURE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_ERROR_PICTURE_H_

#include <string>

#include "experiments/metrics/map_comparison.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::apps {

// Draws the true map, y upward, two pixels a cell and more where it is small: what could be seen
// white, the rest light grey; true surface black where the map has it within the tolerance and blue
// where it is missing; occupied cells of the map dark grey, and red-orange when they are farther
// than that from the surface. A legend below says so. The colours are those of Okabe and Ito that
// all people can tell apart. Throws std::runtime_error with one line when the file cannot be
// written.
void WriteErrorPicture(const map::TrinaryMap& truth, const metrics::MapComparison& comparison,
                       double tolerance_m, const std::string& png_path);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_ERROR_PICTURE_H_
