// SPDX-License-Identifier: BSD-3-Clause
// Aisles between racks, each like the next.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_AISLES_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_AISLES_H_

#include <numbers>
#include <vector>

#include "backend/se2.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::synthetic {

// Their middle lines are so far apart: aisle k is at x = k times that, from y = 0 to 20.
inline constexpr double kAisles_m = 3.0;

// Rack k is 1 m deep, to the left of aisle k; something stands out of its right side here and
// there.
inline Walls Racks(int first, int last) {
  Walls walls;
  for (int k = first; k <= last; ++k) {
    const double left = kAisles_m * k - 2.0, right = left + 1.0;
    AddPolygon({{left, 0},
                {right, 0},
                {right, 4},
                {right + 0.6, 4},
                {right + 0.6, 6},
                {right, 6},
                {right, 9.5},
                {right - 0.5, 9.5},
                {right - 0.5, 12},
                {right, 12},
                {right, 14},
                {right + 0.4, 14},
                {right + 0.4, 17},
                {right, 17},
                {right, 20},
                {left, 20}},
               0.0, &walls);
  }
  return walls;
}

// A node each metre, up the aisle or down.
inline std::vector<backend::SE2> DriveAisle(int aisle, bool up) {
  std::vector<backend::SE2> poses;
  for (int k = 0; k <= 20; ++k) {
    poses.push_back(
        {kAisles_m * aisle, up ? 1.0 * k : 20.0 - k, (up ? 0.5 : -0.5) * std::numbers::pi});
  }
  return poses;
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_AISLES_H_
