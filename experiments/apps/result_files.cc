// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/result_files.h"

#include <algorithm>

#include "backend/graph/g2o_io.h"
#include "backend/graph/kitti_io.h"
#include "backend/graph/stamps_io.h"
#include "experiments/apps/map_cells.h"
#include "experiments/apps/map_picture.h"
#include "experiments/apps/world_file.h"
#include "frontend/map/map_server_io.h"

namespace gmapping_spa::apps {

void WriteResultFiles(const backend::Trajectory& trajectory, const backend::PoseGraph& graph,
                      const map::TrinaryMap& map, const Stretches& stretches, OutputFiles* files) {
  files->Write("trajectory.tum", [&](std::ostream& out) { backend::WriteTum(trajectory, out); });
  files->Write("trajectory.kitti",
               [&](std::ostream& out) { backend::WriteKitti(trajectory, out); });
  files->Write("times.txt", [&](std::ostream& out) { backend::WriteTimes(trajectory, out); });
  files->Write("graph.g2o", [&](std::ostream& out) { backend::WriteG2o(graph, out); });
  files->Write("graph.stamps", [&](std::ostream& out) { backend::WriteStamps(graph, out); });
  files->Write("map.pgm", [&](std::ostream& out) { map::WritePgm(map, out); });
  files->Write("map.yaml", [&](std::ostream& out) { map::WriteMapYaml(map, "map.pgm", out); });

  backend::Trajectory by_time = trajectory;
  std::ranges::stable_sort(by_time, {}, &backend::StampedPose::stamp_s);
  const PicturePlace picture =
      WriteMapPicture(map, by_time, files->TemporaryPath("map.png"), stretches);
  files->Write("map.pngw", [&](std::ostream& out) { WriteWorldFile(picture, out); });
  const PicturePlace cells = WriteMapCells(map, files->TemporaryPath("map_cells.png"));
  files->Write("map_cells.pngw", [&](std::ostream& out) { WriteWorldFile(cells, out); });
}

}  // namespace gmapping_spa::apps
