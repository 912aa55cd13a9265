// Odometry by matching every scan with what was seen on the last metres.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_ODOMETRY_H_
#define GMAPPING_SPA_FRONTEND_SCAN_ODOMETRY_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/endpoint_model.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/scan_points.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// Matches scans with a local map of its own, in its own frame. A particle's map would hold the
// robot to walls of long ago as soon as they are in reach, and tear the way there from the way on:
// where the path returns, is for the loop closing to find.
class ScanOdometry {
 public:
  struct Options {
    scan_matching::GaussNewton::Options gauss_newton;
    scan_matching::EndpointModel::Options endpoint;
    map::OccupancyGrid::Options grid;
    // Standard deviations of the wheels' increment between two scans.
    double floor_m = 0.01;
    double m_per_m = 0.1;
    double floor_rad = 0.005;
    double rad_per_m = 0.05;
    double rad_per_rad = 0.1;
    // A scan is entered into the map after this much motion. The map is given up for one of half
    // that many scans when it holds so many.
    double enter_m = 0.5;
    double enter_rad = 0.3;
    int map_scans = 80;
    // When a match scores below this part of what recent scans scored, the wheels may have slipped:
    // the surroundings are searched, this far to either side.
    double search_below = 0.8;
    double search_m = 0.3;
    double search_rad = 0.4;
  };

  explicit ScanOdometry(const Options& options);

  // The motion since the scan before, given what the wheels say about it. Of the first scan: none.
  backend::SE2 Advance(const sensor::LaserScan& scan, const backend::SE2& wheels);

 private:
  struct LocalMap {
    map::OccupancyGrid grid;
    int scans = 0;
  };

  backend::SE2 Search(const scan_matching::ScanPoints& points, const backend::SE2& centre,
                      double at_least) const;
  Eigen::Matrix3d WheelInformation(const backend::SE2& wheels) const;
  void Enter(const sensor::LaserScan& scan);

  Options options_;
  scan_matching::GaussNewton matcher_;
  std::vector<LocalMap> maps_;  // the one in use and the one to replace it
  backend::SE2 odom_T_robot_;
  backend::SE2 odom_T_entered_;  // when a scan was last entered
  double recent_score_ = 0.0;    // running mean
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SCAN_ODOMETRY_H_
