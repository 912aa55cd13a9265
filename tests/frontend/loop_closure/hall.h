// SPDX-License-Identifier: BSD-3-Clause
// A hall in which every place looks different.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_HALL_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_HALL_H_

#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::synthetic {

// Built around the way of DriveOnRing, on which it hits nothing.
inline Walls Hall() {
  Walls walls;
  AddPolygon({{-2, -1},
              {6, -0.2},
              {7, -2.5},
              {20, -3},
              {24, 6},
              {19, 8},
              {18.5, 15},
              {3, 17},
              {2, 13},
              {-3, 11},
              {-0.5, 6}},
             0.0, &walls);
  AddPolygon({{5, 4}, {6, 4.4}, {5.3, 6}}, 0.0, &walls);
  AddPolygon({{9, 3}, {13, 5}, {11, 7.5}}, 0.0, &walls);
  AddPolygon({{3.2, 7.5}, {4.2, 8.3}, {3.2, 9}}, 0.0, &walls);
  return walls;
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LOOP_CLOSURE_HALL_H_
