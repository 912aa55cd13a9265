// SPDX-License-Identifier: BSD-3-Clause
// What a robot has seen on its last meters, before it is known where it is.
#ifndef GMAPPING_SPA_FRONTEND_LOCALIZATION_VIEWS_H_
#define GMAPPING_SPA_FRONTEND_LOCALIZATION_VIEWS_H_

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "backend/se2.h"
#include "frontend/scan_matching/scan_points.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::localization {

// Keeps a scan each time that the robot has moved on, as far back as the motion between scans can
// be trusted to hold them together.
class Views {
 public:
  struct Options {
    double every_m = 0.3;
    double every_rad = 0.3;
    double reach_m = 10.0;  // of driving
    int max_views = 60;     // a robot that turns on the spot sees the same again
    friend bool operator==(const Options&, const Options&) = default;
  };

  struct View {
    backend::SE2 odom_T_robot;
    double way_m = 0.0;  // driven up to here
    scan_matching::ScanPoints points;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(odom_T_robot, way_m, points);
    }
  };

  explicit Views(const Options& options) : options_(options) {}

  // `motion`: since the scan before. Returns whether the scan became a view: it is the first one,
  // or the robot has moved on.
  bool Add(const sensor::LaserScan& scan, const backend::SE2& motion);

  // The oldest one first.
  const std::deque<View>& views() const { return views_; }
  const backend::SE2& odom_T_robot() const { return odom_T_robot_; }

  // End points of all views in the frame of the robot as it is now, at most one a cell of `cell_m`.
  scan_matching::ScanPoints Joined(double cell_m) const;

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(views_, odom_T_robot_, way_m_);
  }

 private:
  Options options_;
  std::deque<View> views_;
  backend::SE2 odom_T_robot_;
  double way_m_ = 0.0;
};

}  // namespace gmapping_spa::localization

#endif  // GMAPPING_SPA_FRONTEND_LOCALIZATION_VIEWS_H_
