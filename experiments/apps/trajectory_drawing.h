// SPDX-License-Identifier: BSD-3-Clause
// A trajectory and its doubtful stretches, drawn for people.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_TRAJECTORY_DRAWING_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_TRAJECTORY_DRAWING_H_

#include <cairo.h>

#include <map>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "experiments/apps/picture_view.h"
#include "frontend/health.h"

namespace gmapping_spa::apps {

// By kind, as frontend::Health has them.
using Stretches = std::map<std::string, std::vector<frontend::Stretch>>;

// A line from blue to red with a green disc at its start and a red one at its end. Within stretches
// of the kind "ambiguous" it is thick and magenta, of the kind "lost" dashed in black on white;
// other kinds do not show. Poses are in order of time; those that are not finite are left out.
void DrawTrajectory(cairo_t* context, const backend::Trajectory& trajectory,
                    const Stretches& stretches, const PictureView& view);

// A sample of each of these kinds that is there, side by side from (x, y) on, in pixels, written in
// the font of the context.
void DrawStretchLegend(cairo_t* context, const Stretches& stretches, double x, double y);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_TRAJECTORY_DRAWING_H_
