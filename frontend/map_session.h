// SPDX-License-Identifier: BSD-3-Clause
// A run that goes on in a map of before: from another day, another start, by another robot.
#ifndef GMAPPING_SPA_FRONTEND_MAP_SESSION_H_
#define GMAPPING_SPA_FRONTEND_MAP_SESSION_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"
#include "frontend/localization/localizer.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// The old map, in which the robot is looked for: at the begin, and again whenever it was lost.
class MapSession {
 public:
  enum class Use : std::uint8_t {
    kMapOn,    // old and new become one graph, and one map
    kLocalize  // the old map stays as it is
  };

  // What was known when it began.
  struct Known {
    std::vector<backend::SE2> world_T_nodes;
    std::vector<int> nodes;  // that the map is made of: others were never joined with them
    map::OccupancyGrid map;
    backend::Trajectory trajectory;  // of all scans
    std::int64_t first_index = 0;    // of scans to come, LaserScan::index

    explicit Known(const map::OccupancyGrid::Options& grid) : map(grid) {}

    // For sessions (frontend/session).
    template <typename Archive>
    void serialize(Archive& archive) {
      archive(world_T_nodes, nodes, map, trajectory, first_index);
    }
  };

  struct Found {
    double stamp_s = 0.0;
    double after_s = 0.0;  // since the robot was first looked for

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(stamp_s, after_s);
    }
  };

  MapSession(Use use, Known known);
  MapSession(const MapSession&) = delete;
  MapSession& operator=(const MapSession&) = delete;

  bool is_fixed() const { return use_ == Use::kLocalize; }
  const Known& known() const { return known_; }
  int nodes() const { return static_cast<int>(known_.world_T_nodes.size()); }  // of before
  int scans() const { return static_cast<int>(known_.trajectory.size()); }     // of before
  // The scan with its index among those of both runs.
  sensor::LaserScan Numbered(sensor::LaserScan scan) const {
    scan.index += known_.first_index;
    return scan;
  }
  bool searches() const { return localizer_->searches(); }
  const std::vector<Found>& found() const { return found_; }

  struct Outcome {
    // Once the robot is found: the closure between `node` and the old node that is nearest to it.
    std::optional<loop_closure::ClosureRecord> closure;
    bool taken_back = false;  // the latest closure is wrong
  };

  // The next scan, deskewed, and the motion since the one before. `node`: the newest one, and
  // `robot_T_node` from the robot at this scan.
  Outcome AddScan(const sensor::LaserScan& scan, const backend::SE2& motion, int node,
                  const backend::SE2& robot_T_node);

  // The robot is lost: looks for it anew.
  void BeginPiece();

  template <typename Archive>
  void serialize(Archive& archive) {
    archive(use_, known_, begin_s_, found_);
    if constexpr (Archive::is_loading::value) MakeLocalizer();
    archive(*localizer_);
  }

 private:
  loop_closure::ClosureRecord ClosureAt(const localization::Located& located, int node,
                                        const backend::SE2& robot_T_node) const;
  void MakeLocalizer() { localizer_.emplace(localization::Localizer::Options{}, &known_.map); }

  Use use_;
  Known known_;
  std::optional<localization::Localizer> localizer_;  // refers to the map
  std::optional<double> begin_s_;                     // of the search
  std::vector<Found> found_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_MAP_SESSION_H_
