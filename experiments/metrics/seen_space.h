// SPDX-License-Identifier: BSD-3-Clause
// What of a world a robot with a laser could have seen on its way.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_SEEN_SPACE_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_SEEN_SPACE_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// The free cells of a true map that were in sight, and the sides of its other cells where sight
// ended.
struct SeenSpace {
  int width = 0, height = 0;        // those of the true map
  std::vector<std::uint8_t> sides;  // of each cell: bit i stands for kSides[i]
  std::vector<std::uint8_t> seen;   // of each cell: 1 when it is free and was in sight
  int view_points = 0;

  // False outside of the map.
  bool IsSeen(int column, int row) const {
    return column >= 0 && column < width && row >= 0 && row < height &&
           seen[static_cast<std::size_t>(row) * width + column] != 0;
  }
  bool IsSideSeen(int column, int row, int side) const {
    return (sides[static_cast<std::size_t>(row) * width + column] >> side & 1) != 0;
  }
};

// Looks around in a true map, from one true pose after the other: from the first one and then from
// each that is at least 0.25 m from the last view point, in 1440 directions, up to max_range_m or
// to the first cell that is not free. A pose in a cell that is not free, or outside of the map, is
// no view point. Headings do not count.
class Lookout {
 public:
  // `truth` outlives this.
  Lookout(const map::TrinaryMap* truth, double max_range_m);

  void Look(const backend::SE2& truth_T_robot);
  // From the poses so far.
  const SeenSpace& seen() const { return seen_; }

 private:
  const map::TrinaryMap* truth_;
  double max_range_m_;
  std::vector<Eigen::Vector2d> directions_;
  std::optional<Eigen::Vector2d> last_view_point_;
  SeenSpace seen_;
};

// What a Lookout sees from all true poses; throws std::runtime_error when there is no view point.
SeenSpace LookAround(const map::TrinaryMap& truth, const backend::Trajectory& true_poses,
                     double max_range_m);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_SEEN_SPACE_H_
