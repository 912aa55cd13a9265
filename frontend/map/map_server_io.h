// SPDX-License-Identifier: BSD-3-Clause
// Maps as the image and YAML pair of ROS's map_server.
//
// The image is a PGM (P5) with row 0 at the top: 254 free, 0 occupied, 205 unknown. The YAML gives
// the resolution in m/pixel, the pose [x, y, yaw] of the lower left corner in the world frame, and
// the thresholds that turn darkness into states (http://wiki.ros.org/map_server).
#ifndef GMAPPING_SPA_FRONTEND_MAP_MAP_SERVER_IO_H_
#define GMAPPING_SPA_FRONTEND_MAP_MAP_SERVER_IO_H_

#include <cstdint>
#include <ostream>
#include <string>

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::map {

// The grey of a cell in the image.
std::uint8_t PixelOf(CellState state);

void WritePgm(const TrinaryMap& map, std::ostream& out);

// `image_name` is the path of the image relative to the folder of the YAML file.
void WriteMapYaml(const TrinaryMap& map, const std::string& image_name, std::ostream& out);

// Reads the pair named by its YAML file; the image may be PGM, PPM or PNG. States are those of
// map_server's trinary mode: with darkness d = 1 - (mean of the channels) / 255, or 1 - d when
// `negate` is set, a pixel is occupied where d > occupied_thresh, else free where d < free_thresh,
// else unknown. What WritePgm and WriteMapYaml wrote comes back exactly.
// Keys that map_server does not know are ignored, so that other tools may add theirs.
// Throws std::runtime_error "<path>[:<line>]: <what was expected, what was found>" when a key or
// the image is missing or broken, when the map is rotated (yaw other than 0), when `mode` is other
// than trinary, and above kMaxMapCells.
TrinaryMap ReadMap(const std::string& yaml_path);

// 800 m x 800 m at 0.05 m. Beyond it, a broken header is likelier than a map.
inline constexpr std::int64_t kMaxMapCells = std::int64_t{1} << 28;

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_MAP_SERVER_IO_H_
