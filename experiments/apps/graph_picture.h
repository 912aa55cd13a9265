// SPDX-License-Identifier: BSD-3-Clause
// A pose graph as a picture for people.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_PICTURE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_PICTURE_H_

#include <string>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::apps {

// Draws the graph before and after an optimization side by side, each filling its half: odometry
// and scan matches blue, loop closures red, y upward. Throws std::runtime_error with one line when
// the file cannot be written.
void WriteGraphPicture(const backend::PoseGraph& before, const backend::PoseGraph& after,
                       const std::string& png_path);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_GRAPH_PICTURE_H_
