// SPDX-License-Identifier: BSD-3-Clause
// A drive that comes back from far away, or into a place that looks like the first one.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_FAR_DRIVE_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_FAR_DRIVE_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/loop_closure/local_map.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::synthetic {

// The Ring with its first side as it is, and everything else different.
inline Walls TwinOfTheFirstSide() {
  Walls walls;
  AddPolygon({{0, 0},
              {4, 0},
              {4, -0.8},
              {5, -0.8},
              {5, 0},
              {11, 0},
              {11, 0.5},
              {11.4, .5},
              {11.4, 0},
              {18, 0},
              {24, 4},
              {24, 20},
              {12, 26},
              {-9, 20},
              {-12, 9},
              {-3, 1.4}},
             0.0, &walls);
  AddPolygon({{3, 3}, {7, 3}, {7, 3.6}, {8, 3.6}, {8, 3}, {15, 3}, {15, 4}, {9, 5}, {3, 4}}, 0.0,
             &walls);
  return walls;
}

// Nodes every metre through the Ring, then far out where nothing is seen and back, then into
// `walls` for `back_m` of the same way. From far out on the estimate is wrong by `error`.
struct FarDrive {
  FarDrive(double out_m, const Walls& walls, double back_m, const backend::SE2& error) {
    Add(DriveOnRing(0, 40, 1.0), Ring(), {});
    const int steps = static_cast<int>(out_m / 5.0);
    std::vector<backend::SE2> out, home;
    for (int k = 1; k <= steps; ++k) out.push_back({0.0, -2.5 * k, 0.0});
    for (int k = steps; k > 0; --k) home.push_back({5.0, -2.5 * k, 0.0});
    Add(out, {}, {});
    Add(home, {}, error);
    first_node_back = static_cast<int>(truth.size());
    Add(DriveOnRing(0.3, 0.3 + back_m, 1.0), walls, error);
  }

  FarDrive(const FarDrive&) = delete;  // scan_of_node refers to this
  FarDrive& operator=(const FarDrive&) = delete;

  void Add(const std::vector<backend::SE2>& poses, const Walls& walls, const backend::SE2& error) {
    for (const sensor::LaserScan& scan : ScansAt(poses, walls, {.usable_range_m = 12.0})) {
      scans.push_back(scan);
    }
    for (const backend::SE2& pose : poses) {
      truth.push_back(pose);
      estimate.push_back(error * pose);
    }
  }

  std::vector<backend::SE2> truth, estimate;
  std::vector<sensor::LaserScan> scans;
  int first_node_back = 0;
  loop_closure::ScanOfNode scan_of_node = [this](int node) { return scans.at(node); };
};

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_FAR_DRIVE_H_
