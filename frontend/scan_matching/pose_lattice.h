// SPDX-License-Identifier: BSD-3-Clause
// The discretized search window of correlative scan matching, and how well its poses can fit.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_POSE_LATTICE_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_POSE_LATTICE_H_

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/field_pyramid.h"

namespace gmapping_spa::scan_matching {

// Poses of a lattice: 2^level positions in x, as many in y, at as many angles, from (x, y, angle)
// on, which are counted in steps from the middle of the lattice. A single pose at level 0.
struct PoseBlock {
  int level = 0;
  int angle = 0;
  int x = 0;
  int y = 0;
  // At level 0 the sum, over the points, of the bytes of the field at this pose. Above, no pose of
  // the block has a larger sum.
  int bound = std::numeric_limits<int>::max();
};

// The poses initial + (i cells, j cells, k angular steps) with |i|, |j| <= linear_steps and |k| <=
// angular_steps. Shifts are by whole cells so that all poses of an angle share the cells of the
// rotated points. Precondition: an angular step moves no point farther than a cell.
class PoseLattice {
 public:
  struct Shape {
    backend::SE2 initial;  // map_T_scan in the middle
    double linear_step_m;  // the resolution of the field
    double angular_step_rad;
    int linear_steps;
    int angular_steps;
  };

  // `points` in the frame of the scan. `pyramid` must outlive this. Not to be shared by threads.
  PoseLattice(const Shape& shape, const FieldPyramid* pyramid,
              const std::vector<Eigen::Vector2d>& points);

  const Shape& shape() const { return shape_; }

  // map_T_scan of a single pose.
  backend::SE2 Pose(const PoseBlock& pose) const;

  // Blocks without a bound that together hold all poses, each pose once. Their level is above 0.
  std::vector<PoseBlock> Roots() const;

  // Calls visit(part) for each of the up to eight blocks, one level below, that `block` consists
  // of, with their bounds. Parts without poses of the lattice are left out. Precondition:
  // block.level > 0.
  template <typename Visit>
  void ForEachPart(const PoseBlock& block, const Visit& visit) const {
    const int level = block.level - 1, size = 1 << level;
    for (int angle = block.angle; angle <= block.angle + size; angle += size) {
      if (angle > shape_.angular_steps) break;
      const Eigen::Array4i bounds = Bounds({level, angle, block.x, block.y});
      for (int i = 0; i < 4; ++i) {
        const int x = block.x + (i & 1) * size, y = block.y + (i >> 1) * size;
        if (x > shape_.linear_steps || y > shape_.linear_steps) continue;
        visit(PoseBlock{level, angle, x, y, bounds[i]});
      }
    }
  }

 private:
  // Bounds of `first` and of the blocks of its level to the right, above, and above to the right.
  // Together they take little longer than one.
  Eigen::Array4i Bounds(const PoseBlock& first) const;

  // Of the points at x = y = 0 and the middle of the group-th 2^level angles.
  const std::vector<map::CellIndex>& Cells(int level, int group) const;

  Shape shape_;
  const FieldPyramid* pyramid_;
  std::vector<Eigen::Vector2d> points_;
  // By level and group, see Cells; empty until asked for: most angles of a large window never are.
  mutable std::vector<std::vector<std::vector<map::CellIndex>>> cells_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_POSE_LATTICE_H_
