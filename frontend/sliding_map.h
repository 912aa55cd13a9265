// SPDX-License-Identifier: BSD-3-Clause
// The map of the last metres, for lidar odometry.
#ifndef GMAPPING_SPA_FRONTEND_SLIDING_MAP_H_
#define GMAPPING_SPA_FRONTEND_SLIDING_MAP_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/correlative_matching.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// Holds the last scans entered, between half of `scans` and all of them; a scan of few beams counts
// as a part of one, by its density.
class SlidingMap {
 public:
  SlidingMap(const map::OccupancyGrid::Options& grid, int scans);

  bool empty() const { return maps_.empty(); }
  // Not of an empty one.
  const map::OccupancyGrid& grid() const;

  void Insert(const sensor::LaserScan& scan, const backend::SE2& odom_T_robot);
  // Forgets everything.
  void Clear();

  // For an exhaustive search of the surroundings of the robot; made when it is first asked for
  // after a change.
  const scan_matching::CorrelativeMatcher& Search(
      const scan_matching::CorrelativeMatcher::Options& options, const backend::SE2& odom_T_robot,
      double reach_m);

  // For sessions (frontend/session). What is searched is made again.
  template <typename Archive>
  void serialize(Archive& archive) {
    std::size_t count = maps_.size();
    archive(count);
    archive.Resize(count, LocalMap{map::OccupancyGrid(grid_options_)}, &maps_);
    for (LocalMap& local : maps_) archive(local);
    archive(searched_);
  }

 private:
  struct LocalMap {
    map::OccupancyGrid grid;
    double scans = 0.0;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(grid, scans);
    }
  };
  // The part of the map in use that a search knows.
  struct Surroundings {
    backend::SE2 center;
    double reach_m;  // without a default, which Clang knows too late for std::optional

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(center, reach_m);
    }
  };

  map::OccupancyGrid::Options grid_options_;
  int scans_;
  std::vector<LocalMap> maps_;            // the one in use and the one to replace it
  std::optional<Surroundings> searched_;  // since the last change
  std::unique_ptr<scan_matching::CorrelativeMatcher> search_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SLIDING_MAP_H_
