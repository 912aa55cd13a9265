// SPDX-License-Identifier: BSD-3-Clause
// How long the laser takes for a scan, learned from how scans bend when the robot turns.
#ifndef GMAPPING_SPA_FRONTEND_SWEEP_DURATION_H_
#define GMAPPING_SPA_FRONTEND_SWEEP_DURATION_H_

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// CARMEN logs do not tell it, and what bags tell is wrong at times. A laser of 75 turns a second
// bends nothing; one of 5 turns a second bends a scan by 12 degrees while the robot turns by 60
// degrees a second. Scans of a steady turn are all bent alike and fit each other: a scan of a turn
// is compared with the last one before it.
class SweepDuration {
 public:
  // `known_s`: the duration, where it is known; it is not learned then.
  SweepDuration(const map::OccupancyGrid::Options& grid,
                const scan_matching::GaussNewton::Options& gauss_newton,
                const std::optional<double>& known_s);

  // What the log says, 0 for nothing. It counts until it is proven to be far off.
  void Tell(double sweep_s);
  // Whether it is.
  bool contradicts_log() const { return is_proven_ && told_s_ > 0.0; }

  // From the first beam to the last one, s, by which scans are to be deskewed; negative where the
  // beams of a scan are listed in the opposite order of time. 0 until another duration is told or
  // proven.
  double value_s() const { return value_s_; }

  // The poses of the scans to come are those of another frame.
  void BeginFrame() {
    latest_ = {};
    straight_ = {};
  }

  // A scan as it was measured, where it was matched. `velocity`: of the robot, a twist in its frame
  // (m/s, m/s, rad/s).
  void Learn(const sensor::LaserScan& scan, const backend::SE2& odom_T_robot,
             const Eigen::Vector3d& velocity);

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(latest_, chances_, measurements_, is_known_, is_proven_, told_s_, value_s_);
    Reference of_before;  // sessions of version 1 have had two
    for (Reference* reference : {&of_before, &straight_}) {
      bool has_map = reference->grid.has_value();  // by what value_s_ was when it was made
      archive(reference->at, has_map);
      if (!has_map) continue;
      if (!reference->grid) reference->grid.emplace(grid_options_);
      archive(*reference->grid);
    }
  }

 private:
  // A scan as it was measured, where it was matched.
  struct MatchedScan {
    sensor::LaserScan scan;
    backend::SE2 odom_T_robot;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(scan, odom_T_robot, velocity);
    }
  };
  // What later scans are compared with, and a map of it, made when it is needed.
  struct Reference {
    MatchedScan at;
    std::optional<map::OccupancyGrid> grid;
  };
  struct Measurement {
    double sweep_s;
    double information;  // 1/s^2, as if all beams were independent

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(sweep_s, information);
    }
  };

  static double WeightedMedian(std::deque<Measurement> measurements);
  void Measure(double interval_s);
  void Conclude();

  map::OccupancyGrid::Options grid_options_;
  scan_matching::GaussNewton::Options gauss_newton_;
  // Waits for the next one, as half of its sweep comes after its stamp.
  MatchedScan latest_;
  Reference straight_;                    // the last one of a robot that did not turn
  int chances_ = 0;                       // to measure, since there are enough
  std::deque<Measurement> measurements_;  // lately
  bool is_known_;
  bool is_proven_ = false;
  double told_s_ = 0.0;
  double value_s_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SWEEP_DURATION_H_
