// SPDX-License-Identifier: BSD-3-Clause
// A map and a trajectory as a picture for people.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_MAP_PICTURE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_MAP_PICTURE_H_

#include <string>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/trajectory_drawing.h"
#include "experiments/apps/world_file.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::apps {

// Draws the known part of the map (unknown grey, free white, occupied black, y upward) with the
// trajectory, whose poses are in the map's frame and in order of time, as a line from blue to red,
// a green disc at its start and a red one at its end, and a scale bar. The longer side has 800 to
// 2000 pixels. The trajectory may be empty. Where its stamps are within a stretch of the kind
// "ambiguous", the line is thick and magenta, within one of the kind "lost" dashed in black on
// white; a legend beside the scale bar says so. Returns where the picture lies in the map's frame.
// Throws std::runtime_error with one line when the file cannot be written.
PicturePlace WriteMapPicture(const map::TrinaryMap& map, const backend::Trajectory& trajectory,
                             const std::string& png_path, const Stretches& stretches = {});

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_MAP_PICTURE_H_
