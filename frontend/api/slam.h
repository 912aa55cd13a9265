// SPDX-License-Identifier: BSD-3-Clause
// SLAM for programs: laser scans in; poses, map and pose graph out.
#ifndef GMAPPING_SPA_FRONTEND_API_SLAM_H_
#define GMAPPING_SPA_FRONTEND_API_SLAM_H_

#include <memory>

#include "backend/graph/pose_graph.h"
#include "backend/graph/trajectory_io.h"
#include "backend/plugin/optimizer.h"
#include "backend/se2.h"
#include "frontend/api/scan_result.h"
#include "frontend/api/slam_options.h"
#include "frontend/map/trinary_map.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa {

/// Improved GMapping (Tao et al. 2021): a Rao-Blackwellized particle filter whose best particle's
/// path is a pose graph, which a back end optimizes in a thread of its own.
///
/// Frames and units: the world frame is the pose of the robot at the first scan; meters, radians
/// and seconds throughout.
///
/// Threads: use one object in one thread at a time; different objects do not share anything. It has
/// a thread for the back end and, while it works, SlamOptions::threads for the particles. Results
/// depend on the scans and the options only, but with SlamOptions::GraphThread::kAsync.
///
/// Memory grows with the scans (all are kept, some kB each, for corrections and the final map),
/// with the area seen and with the particles, which share what their maps have in common.
///
/// Errors: what the caller did wrong throws std::invalid_argument or std::logic_error with one line
/// and changes nothing. A back end that fails, throws or hangs costs its result and a warning of
/// one line (by glog, on stderr), no more. Bad odometry and scans that fit nothing are no errors:
/// see ScanResult.
class Slam {
 public:
  /// Loads the back end SlamOptions::backend. Throws std::invalid_argument on options out of range,
  /// and std::runtime_error where there is no such back end, or it cannot do what
  /// SlamOptions::optimizer asks for (a loss, a setting).
  explicit Slam(const SlamOptions& options = {});

  /// With a back end of the program's own, in place of SlamOptions::backend; not null. It is called
  /// in another thread, one call at a time, with SlamOptions::optimizer, and may be used there a
  /// little longer than this object lives.
  Slam(const SlamOptions& options, std::shared_ptr<backend::Optimizer> optimizer);

  ~Slam();
  Slam(Slam&&) noexcept;
  Slam& operator=(Slam&&) noexcept;

  /// Takes the next scan, in the order of time; not deskewed. LaserScan::index is not looked at.
  /// Without odometry set LaserScan::has_odometry to false, or SlamOptions::odometry to kLidarOnly.
  ///
  /// Takes one to five milliseconds a scan of 180 beams on average; more where the filter is
  /// updated, a loop is looked for or a correction rebuilds the maps, and blocks up to
  /// SlamOptions::graph_timeout_s for the back end where its result is due. Throws
  /// std::invalid_argument when the scan has a stamp, pose or beam that is not finite,
  /// std::runtime_error when the odometry leads out of the area that a map can cover (26 km at 5
  /// cm), std::logic_error after Finish.
  ScanResult AddScan(const sensor::LaserScan& scan);

  /// After the last scan: waits for the back end (up to ten times SlamOptions::graph_timeout_s a
  /// call) and, with SlamOptions::final_optimization, closes the loops that are left, optimizes,
  /// aligns all scans and builds the map from all of them. On recorded logs it takes a quarter to a
  /// third of the time of all AddScan. From then on, what is asked below is the final result. Does
  /// nothing the second time.
  void Finish();

  // What is known by now. Each needs a scan first, else throws std::logic_error.

  /// Pose of the robot at the latest scan. In constant time.
  backend::SE2 CurrentPose() const;
  /// The map of the best particle, decided by SlamOptions::occupied_threshold; before Finish it is
  /// made of the scans that updated the filter. In time of its rectangle's number of cells.
  map::TrinaryMap CurrentMap() const;
  /// The best particle's path, one node per update with ids 0, 1, ..., and the accepted loop
  /// closures. In time of its size.
  backend::PoseGraph CurrentGraph() const;
  /// Poses of all scans in the order in which they were added. In time of their number.
  backend::Trajectory CurrentTrajectory() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_FRONTEND_API_SLAM_H_
