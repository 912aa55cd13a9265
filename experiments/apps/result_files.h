// SPDX-License-Identifier: BSD-3-Clause
// The files of a trajectory, a graph and a map.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_RESULT_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_RESULT_FILES_H_

#include "backend/graph/pose_graph.h"
#include "backend/graph/trajectory_io.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/trajectory_drawing.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::apps {

// Writes trajectory.tum, trajectory.kitti and times.txt; graph.g2o and graph.stamps; map.pgm,
// map.yaml, map_cells.png and map.png, both with their world files. `stretches` are those that
// map.png draws differently (map_picture.h).
void WriteResultFiles(const backend::Trajectory& trajectory, const backend::PoseGraph& graph,
                      const map::TrinaryMap& map, const Stretches& stretches, OutputFiles* files);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_RESULT_FILES_H_
