// SPDX-License-Identifier: BSD-3-Clause
// How good maps of the tour are by now, by the numbers of evaluate_map and evaluate_trajectory.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_MAP_SCORER_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_MAP_SCORER_H_

#include <cstddef>
#include <optional>

#include "backend/graph/trajectory_io.h"
#include "experiments/drive/recorded_tour.h"
#include "experiments/metrics/seen_space.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::drive {

// Without a value is what cannot be measured yet.
struct MapScore {
  double stamp_s = 0.0;         // of the last scan
  std::optional<double> ate_m;  // RMSE, aligned by SE(2)
  std::optional<double> iou;    // of occupied cells and true surface
};

class MapScorer {
 public:
  // Both outlive this.
  MapScorer(const map::TrinaryMap* truth, const RecordedTour* tour, double max_range_m)
      : truth_(truth), tour_(tour), lookout_(truth, max_range_m) {}

  // Against what could be seen up to the last pose of `trajectory`, which does not end sooner than
  // the one scored before.
  MapScore Score(const backend::Trajectory& trajectory, const map::OccupancyGrid& grid,
                 double occupied_threshold);

 private:
  const map::TrinaryMap* truth_;
  const RecordedTour* tour_;
  backend::Trajectory true_poses_;
  std::size_t steps_ = 0;  // of the tour that true_poses_ are of
  std::size_t looked_ = 0;
  metrics::Lookout lookout_;
};

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_MAP_SCORER_H_
