// SPDX-License-Identifier: BSD-3-Clause
// Maps of corrected trajectories, rebuilt from the scans as far back as is needed.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MAP_HISTORY_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MAP_HISTORY_H_

#include <cstddef>
#include <functional>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/map/scan_insertion.h"
#include "frontend/particle_filter/trajectory_tree.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::particle_filter {

// Enters the scans of a trajectory tree into maps, one map a leaf. Where leaves share a history, it
// is entered once and the tiles are shared (copy on write). Snapshots of the map on the way, which
// cost little for the same reason, spare a later call the part of the history that has not moved.
class MapHistory {
 public:
  using ScanOfStep = std::function<sensor::LaserScan(int step)>;

  // A pose that moved less than both tolerances stays in the map as it was entered.
  struct Options {
    double tolerance_m = 0.01;
    double tolerance_rad = 0.002;
    int snapshot_every = 50;  // steps
    friend bool operator==(const Options&, const Options&) = default;
  };

  MapHistory(const Options& options, const map::OccupancyGrid::Options& grid,
             const map::InsertionOptions& insertion);

  // Forgets the snapshots: the scans are other ones from now on.
  void Forget();

  // Maps of the leaves, in their order.
  std::vector<map::OccupancyGrid> Rebuild(const TrajectoryTree& tree,
                                          const std::vector<TrajectoryTree::Index>& leaves,
                                          const ScanOfStep& scan_of_step);

  // For sessions (frontend/session). Poses that moved a little stay as they were entered, so that
  // the snapshots cannot be made again.
  template <typename Archive>
  void serialize(Archive& archive) {
    std::size_t count = snapshots_.size();
    archive(count);
    archive.Resize(count, Snapshot{0, empty_}, &snapshots_);
    for (Snapshot& snapshot : snapshots_) archive(snapshot);
    archive(entered_);
  }

 private:
  struct Snapshot {
    int steps = 0;  // that it holds: 0 ... steps - 1
    map::OccupancyGrid map;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(steps, map);
    }
  };

  bool Moved(const backend::SE2& a, const backend::SE2& b) const;
  void DropSnapshotsThatMoved(const std::vector<backend::SE2>& trunk);

  Options options_;
  map::OccupancyGrid empty_;
  map::InsertionOptions insertion_;
  std::vector<Snapshot> snapshots_;    // by number of steps
  std::vector<backend::SE2> entered_;  // poses of the steps that the last snapshot holds
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MAP_HISTORY_H_
