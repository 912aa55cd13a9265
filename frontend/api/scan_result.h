// SPDX-License-Identifier: BSD-3-Clause
// What came of a scan.
#ifndef GMAPPING_SPA_FRONTEND_API_SCAN_RESULT_H_
#define GMAPPING_SPA_FRONTEND_API_SCAN_RESULT_H_

#include "backend/se2.h"

namespace gmapping_spa {

struct ScanResult {
  /// The likeliest pose of the robot at this scan, by what is known by now.
  backend::SE2 world_T_robot;
  bool updated = false;      ///< the particles were updated: the pose graph has more nodes
  bool closed_loop = false;  ///< loop closures were accepted, or taken back
  /// An optimized graph corrected the particles: poses and map of before have moved, and
  /// world_T_robot may have jumped.
  bool corrected = false;
  bool ambiguous = false;  ///< several motions fit the scan; the particles share them out
  bool lost = false;       ///< the scan fits nothing before: world_T_robot is a guess
};

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_FRONTEND_API_SCAN_RESULT_H_
