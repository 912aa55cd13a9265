// SPDX-License-Identifier: BSD-3-Clause
// Upper bounds of a likelihood field over squares of cells, for branch and bound.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_FIELD_PYRAMID_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_FIELD_PYRAMID_H_

#include <vector>

#include "frontend/scan_matching/likelihood_field.h"

namespace gmapping_spa::scan_matching {

// Level h holds at each cell (x, y) the maximum of the field over the cells from (x - r, y - r) to
// (x + 2^h - 1 + r, y + 2^h - 1 + r), where r = Reach(h). Without r these are the precomputed grids
// of Hess et al., "Real-time loop closure in 2D lidar SLAM" (ICRA 2016): bounds for 2^h x 2^h
// shifts of a point. With it they hold for 2^h angles as well. All levels have the cells of the
// field; they are larger by what their squares reach into it.
class FieldPyramid {
 public:
  // Precondition: 1 <= levels <= 16.
  FieldPyramid(ByteGrid field, int levels);

  int levels() const { return static_cast<int>(levels_.size()); }
  const ByteGrid& level(int h) const { return levels_[static_cast<std::size_t>(h)]; }

  // How many cells a point may move, along x and along y, between the middle of 2^h angles and any
  // of them, if it moves by at most a cell from one angle to the next: (2^h - 1) / 2, rounded up.
  static int Reach(int h) { return (1 << h) / 2; }

 private:
  std::vector<ByteGrid> levels_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_FIELD_PYRAMID_H_
