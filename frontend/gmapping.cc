#include "frontend/gmapping.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "frontend/map/map_server_io.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// Inverse of the covariance of a pose, rotated from the world frame to the frame of the node that
// the edge starts at.
Eigen::Matrix3d InformationInFrameOf(const SE2& world_T_i, const Eigen::Matrix3d& covariance) {
  Eigen::Matrix3d world_R_i = Eigen::Matrix3d::Identity();
  world_R_i.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(world_T_i.theta).toRotationMatrix();
  const Eigen::Matrix3d information = world_R_i.transpose() * covariance.inverse() * world_R_i;
  return 0.5 * (information + information.transpose());  // symmetric to the last bit
}

}  // namespace

Gmapping::Gmapping(const Options& options,
                   std::shared_ptr<const scan_matching::ScanMatcher> matcher,
                   backend::PoseGraphSink* sink)
    : options_(options), filter_(options.filter, std::move(matcher)), sink_(sink) {}

void Gmapping::AddScan(const sensor::LaserScan& scan) {
  const bool first = counts_.scans++ == 0;
  if (first) odom_T_last_scan_ = scan.odom_T_robot;
  const SE2 increment = Between(odom_T_last_scan_, scan.odom_T_robot);
  odom_T_last_scan_ = scan.odom_T_robot;
  const double linear_m = increment.translation().norm();
  const double angular_rad = std::abs(increment.theta);
  linear_since_update_m_ += linear_m;
  angular_since_update_rad_ += angular_rad;

  const bool is_update = first || linear_since_update_m_ >= options_.linear_update_m ||
                         angular_since_update_rad_ >= options_.angular_update_rad;
  // In units of what triggers an update; the 1e-9 spreads by number of scans if nothing moved.
  const double motion = linear_m / std::max(options_.linear_update_m, 1e-3) +
                        angular_rad / std::max(options_.angular_update_rad, 1e-3) + 1e-9;
  scan_poses_.Add(scan, motion, is_update);
  if (is_update) Update(scan);
}

void Gmapping::Update(const sensor::LaserScan& scan) {
  if (counts_.updates == 0) {
    filter_.Start(scan, SE2{});
  } else {
    const SE2 u = Between(odom_T_last_update_, scan.odom_T_robot);
    CheckArea(scan, u);
    const particle_filter::ParticleFilter::Update update = filter_.Advance(scan, u);
    counts_.resamplings += update.resampled ? 1 : 0;
    counts_.failed_matches += update.failed_matches;
  }
  EmitStep(scan);
  ++counts_.updates;
  odom_T_last_update_ = scan.odom_T_robot;
  linear_since_update_m_ = 0.0;
  angular_since_update_rad_ = 0.0;
}

// A jump of the odometry must not ask for a map that no memory holds.
void Gmapping::CheckArea(const sensor::LaserScan& scan, const SE2& u) {
  double reach_m = 0.0;
  for (const sensor::Beam& beam : scan.beams) reach_m = std::max(reach_m, beam.range_m);
  for (const particle_filter::Particle& particle : filter_.particles()) {
    const Eigen::Vector2d predicted = (particle.world_T_robot * u).translation();
    area_.extend(predicted - Eigen::Vector2d::Constant(reach_m));
    area_.extend(predicted + Eigen::Vector2d::Constant(reach_m));
  }
  const double cells_per_m = 1.0 / options_.filter.grid.resolution_m;
  const Eigen::Vector2d cells = area_.sizes() * cells_per_m;
  // Half the indices: the world's origin is somewhere inside. Negated, so that NaN fails.
  if (!(cells.prod() < map::kMaxMapCells && cells.maxCoeff() < map::kMaxCellIndex / 2)) {
    throw std::runtime_error("scan " + std::to_string(scan.index) +
                             ": the odometry leads out of the area that a map can cover (" +
                             std::to_string(map::kMaxMapCells) + " cells)");
  }
}

// The best particle's latest pose as a node, and how it got there as an edge.
void Gmapping::EmitStep(const sensor::LaserScan& scan) {
  const particle_filter::Particle& best = filter_.particles()[filter_.BestParticle()];
  const std::int64_t id = counts_.updates;
  sink_->AddNode({.id = id, .stamp_s = scan.stamp_s, .world_T_node = best.world_T_robot});
  if (id == 0) return;
  const SE2& previous = best.step.world_T_previous;
  sink_->AddEdge(
      {.i = id - 1,
       .j = id,
       .i_T_j = Between(previous, best.world_T_robot),
       .information = InformationInFrameOf(previous, best.step.world_covariance),
       .kind = best.step.matched ? backend::EdgeKind::kScanMatch : backend::EdgeKind::kOdometry});
}

std::vector<SE2> Gmapping::NodePoses() const { return filter_.Path(filter_.BestParticle()); }

backend::Trajectory Gmapping::ScanTrajectory() const { return scan_poses_.Fill(NodePoses()); }

const map::OccupancyGrid& Gmapping::Map() const {
  return filter_.particles()[filter_.BestParticle()].map;
}

}  // namespace gmapping_spa::frontend
