// SPDX-License-Identifier: BSD-3-Clause
// A log on one page.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_PICTURE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_PICTURE_H_

#include <string>

#include "experiments/apps/log_inspection.h"

namespace gmapping_spa::apps {

// Draws, on 1600 x 1200 pixels: the way of the odometry with the ends of the beams of some scans
// (above, left), how many beams end at which range (above, right), and the lengths and turns of the
// odometry's steps over time, faults in red (below). What the log does not hold stays empty.
// Throws std::runtime_error with one line when the file cannot be written.
void WriteInspectionPicture(const LogSummary& summary, const std::string& png_path);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_INSPECTION_PICTURE_H_
