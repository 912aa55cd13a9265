// SPDX-License-Identifier: BSD-3-Clause
// Improved GMapping: from laser scans to a trajectory, a map and a pose graph.
#ifndef GMAPPING_SPA_FRONTEND_IMPROVED_GMAPPING_H_
#define GMAPPING_SPA_FRONTEND_IMPROVED_GMAPPING_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "backend/graph/pose_graph_sink.h"
#include "frontend/api/scan_result.h"
#include "frontend/control_input.h"
#include "frontend/final_optimization.h"
#include "frontend/graph_thread.h"
#include "frontend/health.h"
#include "frontend/loop_closure/loop_closer.h"
#include "frontend/map_area.h"
#include "frontend/map_session.h"
#include "frontend/particle_filter/particle_filter.h"
#include "frontend/scan_matching/scan_matcher.h"
#include "frontend/scan_poses.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/scan_archive.h"
#include "frontend/slam_result.h"

namespace gmapping_spa::frontend {

// A Rao-Blackwellized particle filter whose best particle's path is a pose graph: a back end
// optimizes it in a thread of its own, and the correction flows back into the particles (Tao et al.
// 2021). With a back end that does nothing it is GMapping (Grisetti, Stachniss, Burgard 2007).
//
// Takes scans one by one, in the order of time. The world frame is the robot's pose at the first
// scan.
class ImprovedGmapping {
 public:
  enum class Correction : std::uint8_t {
    kPose,       // of each particle's current pose: eq. (14) as the paper writes it
    kTrajectory  // of each particle's whole history, and its map
  };

  struct Options {
    // The filter is updated when the robot has moved this far since the last update, one with few
    // beams the sooner (ScanDensity). Zero updates with every scan.
    double linear_update_m = 1.0;
    double angular_update_rad = 0.5;
    particle_filter::ParticleFilter::Options filter;
    ControlInput::Options control;
    bool close_loops = true;
    loop_closure::LoopCloser::Options loop_closer;
    // The back end runs each time that this many new poses came in, and after a loop closure.
    int optimize_every = 20;
    GraphThread::Options graph_thread;
    Correction correction = Correction::kTrajectory;
    // Without it the result is what the best particle knows.
    bool make_final_optimization = true;
    FinalOptimization::Options final_optimization;
    friend bool operator==(const Options&, const Options&) = default;
  };

  struct Counts {
    std::int64_t scans = 0;
    std::int64_t updates = 0;
    std::int64_t resamplings = 0;
    std::int64_t failed_matches = 0;  // summed over particles
    std::int64_t corrections = 0;
    std::int64_t pieces = 1;    // of the map: one more each time the robot was lost
    std::int64_t searched = 0;  // scans for which a window was searched

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(scans, updates, resamplings, failed_matches, corrections, pieces, searched);
    }
  };

  // `optimize` is the back end; it is called in a thread of its own.
  ImprovedGmapping(const Options& options,
                   std::shared_ptr<const scan_matching::ScanMatcher> matcher,
                   GraphThread::OptimizeFunction optimize);

  // See GraphThread::StopWaitingWhen.
  void StopWaitingWhen(std::function<bool()> is_asked) {
    graph_thread_.StopWaitingWhen(std::move(is_asked));
  }

  // See GraphThread::KeepStateOf.
  void KeepStateOf(std::shared_ptr<backend::Optimizer> optimizer) {
    graph_thread_.KeepStateOf(std::move(optimizer));
  }

  // `measured`: not deskewed. Throws std::runtime_error when the odometry leads out of the area
  // that a map can cover.
  ScanResult AddScan(const sensor::LaserScan& measured);

  // Scans to come are of another log, from another start: a new piece of map, until the robot is
  // found in the map of all scans up to now, which FinalOptimization makes. Needs a scan. Health
  // and counts begin anew; rows of trajectories go on. The particles become as many as the options
  // say.
  void BeginSession(MapSession::Use use);
  const std::optional<MapSession>& session() const { return session_; }
  // Whether CurrentPose is a pose in the old map of the session: from the correction of the graph
  // on that follows when the robot was found, until it is lost. True without a session.
  bool IsPlaced() const;

  // The pose graph as it is now: the best particle's path, one node per update with ids 0, 1, ...,
  // and the accepted loop closures.
  void EmitGraph(backend::PoseGraphSink* sink) const;

  // What the best particle knows so far. Each needs at least one scan.
  backend::SE2 CurrentPose() const;
  backend::Trajectory CurrentTrajectory() const;
  const map::OccupancyGrid& CurrentMap() const { return BestParticle().map; }
  SlamResult CurrentResult() const;

  // After the last scan: waits for the back end and makes the final optimization. Needs at least
  // one scan.
  SlamResult Finish();
  // The same without the final optimization.
  SlamResult FinishEarly();

  // Takes over what somebody made of the closures; see LoopCloser::Edit.
  int EditClosures(const std::vector<loop_closure::ClosureRecord>& edited);
  // world_T_node of all nodes, optimized with the closures as they are.
  std::vector<backend::SE2> OptimizedNodes();
  int nodes() const { return static_cast<int>(node_scans_.size()); }
  // How two nodes lie to each other by their scans, where `world_T_nodes` are those poses; see
  // LoopCloser::Measure.
  loop_closure::ClosureRecord MeasureClosure(const std::vector<backend::SE2>& world_T_nodes,
                                             int old_node, int node) const;
  // Like Finish, but with the closures as they are: none is looked for, none is let go of. `refine`
  // as in FinalOptimization::Options.
  SlamResult FinishEdited(int refine);

  const Counts& counts() const { return counts_; }
  const particle_filter::ParticleFilter& filter() const { return filter_; }
  // Of the latest update of the filter; all zero before the second one.
  const particle_filter::ParticleFilter::UpdateResult& latest_update() const {
    return latest_update_;
  }
  const GraphThread& graph_thread() const { return graph_thread_; }
  const loop_closure::LoopCloser& loop_closer() const { return loop_closer_; }
  const Health& health() const { return health_; }
  double resolution_m() const { return options_.filter.grid.resolution_m; }
  // Time from the first beam of a scan to the last one, s, by which scans are deskewed.
  double sweep_s() const { return control_.sweep_s(); }
  // All scans so far.
  const sensor::ScanArchive& scans() const { return archive_; }
  // Whether this is the scan that AddScan was given as the k-th one of the session, from 0.
  bool HasTaken(std::int64_t k, const sensor::LaserScan& scan) const;

  // For sessions (frontend/session): all but what the options say.
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(filter_, health_, control_, loop_closer_, area_, archive_, node_scans_, scan_poses_,
            is_lost_, odom_T_scan_, odom_T_last_update_, increments_since_update_,
            noise_since_update_, linear_since_update_m_, angular_since_update_rad_,
            updates_since_optimization_, closure_waits_, world_T_nodes_before_, closures_before_,
            is_drawn_, counts_, graph_thread_);
    bool in_session = session_.has_value();
    archive(in_session);
    if (!in_session) return;
    if (!session_)
      session_.emplace(MapSession::Use::kMapOn, MapSession::Known(options_.filter.grid));
    archive(*session_);
    if constexpr (Archive::is_loading::value) LeaveSearchToSession();
  }

 private:
  void Process(const sensor::LaserScan& measured, ScanResult* result);
  void BeginPiece(int scans, bool wheels_told_way);
  bool BeginsSession() const { return session_ && archive_.size() == session_->scans(); }
  void LookForRobot(const sensor::LaserScan& scan, const backend::SE2& motion);
  std::vector<bool> DrawnInTheEnd() const;
  std::vector<bool> DrawnScans(const std::vector<bool>& is_piece_drawn) const;
  particle_filter::ParticleFilter::Control ControlSinceUpdate() const;
  bool UpdateIsDue(const backend::SE2& u, double density);
  void ApplyOptimizedGraph(const backend::PoseGraph& optimized);
  void UpdateFilter(const sensor::LaserScan& scan,
                    const std::vector<particle_filter::ParticleFilter::Control>& controls);
  sensor::LaserScan DrawnScanOfNode(int node) const;
  FinalOptimization MakeFinalOptimization(const FinalOptimization::Options& options);
  SlamResult FinishWith(const FinalOptimization::Options& options);
  void ReportPieces(const std::vector<bool>& is_drawn);
  void JoinPieces();
  void LeaveSearchToSession();
  void ReportClosures(const std::vector<backend::SE2>& world_T_nodes);
  bool CloseLoops();
  void StartOptimization();
  void EmitPath(backend::PoseGraphSink* sink) const;
  const particle_filter::Particle& BestParticle() const;
  sensor::LaserScan ScanOfNode(int node) const { return archive_.Get(node_scans_.at(node)); }

  Options options_;
  particle_filter::ParticleFilter filter_;
  particle_filter::ParticleFilter::UpdateResult latest_update_;
  Health health_;
  ControlInput control_;
  loop_closure::LoopCloser loop_closer_;
  GraphThread graph_thread_;
  MapArea area_;

  sensor::ScanArchive archive_;
  std::vector<int> node_scans_;  // positions of the nodes' scans in the archive
  ScanPoses scan_poses_;
  std::vector<bool> is_lost_;  // of each scan in the archive: fits nothing, and is not drawn

  backend::SE2 odom_T_scan_;  // the control inputs so far
  backend::SE2 odom_T_last_update_;
  std::vector<backend::SE2> increments_since_update_;  // of odom_T_scan_
  double noise_since_update_ = 0.0;                    // the largest of the control inputs
  double linear_since_update_m_ = 0.0;
  double angular_since_update_rad_ = 0.0;
  int updates_since_optimization_ = 0;
  bool closure_waits_ = false;                      // for an optimization
  std::vector<backend::SE2> world_T_nodes_before_;  // of the optimization that runs
  std::vector<backend::Edge> closures_before_;      // that it knows
  std::vector<bool> is_drawn_ = {true};  // of each piece whether the particles' maps hold it
  std::optional<MapSession> session_;
  Counts counts_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_IMPROVED_GMAPPING_H_
