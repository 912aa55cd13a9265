// GMapping: from laser scans to a trajectory, a map and a pose graph.
#ifndef GMAPPING_SPA_FRONTEND_GMAPPING_H_
#define GMAPPING_SPA_FRONTEND_GMAPPING_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>

#include "backend/pose_graph_sink.h"
#include "backend/trajectory_io.h"
#include "frontend/particle_filter/particle_filter.h"
#include "frontend/scan_matching/scan_matcher.h"
#include "frontend/scan_poses.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// Takes scans one by one, in the order of time. The world frame is the robot's pose at the first
// scan.
class Gmapping {
 public:
  struct Options {
    // The filter is updated when the robot has moved this far since the last update. Zero updates
    // with every scan.
    double linear_update_m = 1.0;
    double angular_update_rad = 0.5;
    particle_filter::ParticleFilter::Options filter;
  };

  struct Counts {
    std::int64_t scans = 0;
    std::int64_t updates = 0;
    std::int64_t resamplings = 0;
    std::int64_t failed_matches = 0;  // summed over particles
  };

  // `sink` gets a node for every update and an edge from each to the next; it must outlive this.
  Gmapping(const Options& options, std::shared_ptr<const scan_matching::ScanMatcher> matcher,
           backend::PoseGraphSink* sink);

  // Throws std::runtime_error when the odometry leads out of the area that a map can cover.
  void AddScan(const sensor::LaserScan& scan);

  // Estimate of the best particle so far: poses of all scans in the order of the input, poses of
  // the graph's nodes in the order of their ids, and the map. Needs at least one scan.
  backend::Trajectory ScanTrajectory() const;
  std::vector<backend::SE2> NodePoses() const;
  const map::OccupancyGrid& Map() const;

  const Counts& counts() const { return counts_; }
  const particle_filter::ParticleFilter& filter() const { return filter_; }

 private:
  void CheckArea(const sensor::LaserScan& scan, const backend::SE2& u);
  void Update(const sensor::LaserScan& scan);
  void EmitStep(const sensor::LaserScan& scan);

  Options options_;
  particle_filter::ParticleFilter filter_;
  backend::PoseGraphSink* sink_;
  ScanPoses scan_poses_;
  backend::SE2 odom_T_last_scan_;
  backend::SE2 odom_T_last_update_;
  double linear_since_update_m_ = 0.0;
  double angular_since_update_rad_ = 0.0;
  // That the particles have been in, with the reach of the beams; from the origin, the first pose.
  Eigen::AlignedBox2d area_{Eigen::Vector2d::Zero()};
  Counts counts_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_GMAPPING_H_
