#include "frontend/scan_matching/gauss_newton.h"

#include <glog/logging.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "frontend/map/cell_block.h"
#include "frontend/scan_matching/local_surface.h"

namespace gmapping_spa::scan_matching {

using backend::SE2;
using map::CellIndex;
using map::FloorToCell;

namespace {

constexpr float kSingleHit = 1e-4f;  // in squared cells, beyond rounding

struct NormalEquations {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double inliers = 0.0;
};

// LocalSurface::Information, less what it says along a wall: the window moves with the end point,
// so that the spread of hit means along the wall is that of the window and binds nothing to its
// place.
Eigen::Matrix2f AcrossWall(const LocalSurface& surface, float noise_cells) {
  const Eigen::Matrix2f covariance =
      surface.covariance + noise_cells * noise_cells * Eigen::Matrix2f::Identity();
  const float middle = 0.5f * covariance.trace();
  const float half_gap = std::sqrt(std::max(middle * middle - covariance.determinant(), 0.0f));
  const float along = middle + half_gap, across = middle - half_gap;
  Eigen::Matrix2f information = covariance.inverse();
  const float ratio = across / along;  // 1 where it is no wall, but a post
  const float kept = ratio * ratio * ratio * ratio;
  if (half_gap > 1e-6f) {
    information -= (1.0f - kept) / (along * 2.0f * half_gap) *
                   (covariance - across * Eigen::Matrix2f::Identity());
  }
  return information;
}

// Of the beams at `pose`, in metres. `blocks` are refreshed where end points have left them.
NormalEquations Linearize(const map::OccupancyGrid& grid, const ScanPoints& points, const SE2& pose,
                          double noise_sigma_m, double robust_sigmas,
                          std::vector<map::CellBlock>* blocks) {
  const double cells_per_m = 1.0 / grid.resolution_m();
  const auto noise_cells = static_cast<float>(noise_sigma_m * cells_per_m);
  const auto robust = static_cast<float>(robust_sigmas * robust_sigmas);
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  NormalEquations sum;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ScanPoint& point = points[k];
    // From the robot to the end point in the directions of the world, and the end point.
    const double arm_x = c * point.x_m - s * point.y_m, arm_y = s * point.x_m + c * point.y_m;
    const double x = (pose.x + arm_x) * cells_per_m, y = (pose.y + arm_y) * cells_per_m;
    const CellIndex cell{FloorToCell(x), FloorToCell(y)};
    map::CellBlock& block = (*blocks)[k];
    if (!block.Covers(cell)) block.CopyFrom(grid, cell);
    LocalSurface surface;
    if (!surface.Fit(block, cell, x, y)) continue;
    // A single hit has no direction; the next one on that wall may be anywhere along it.
    if (surface.covariance.trace() < kSingleHit) continue;
    const Eigen::Matrix2f information = AcrossWall(surface, noise_cells);
    const Eigen::Vector2f toward = information * surface.offset;
    const double weight = 1.0f / (1.0f + surface.offset.dot(toward) / robust);
    // The error is the end point minus the surface; its derivative by (x, y, theta) is [I, n] with
    // n the arm turned by a right angle.
    const double scale = weight * cells_per_m * cells_per_m;
    const double xx = scale * information(0, 0), xy = scale * information(0, 1);
    const double yy = scale * information(1, 1);
    const double nx = -arm_y, ny = arm_x;
    const double xn = xx * nx + xy * ny, yn = xy * nx + yy * ny;
    sum.hessian(0, 0) += xx;
    sum.hessian(1, 0) += xy;
    sum.hessian(1, 1) += yy;
    sum.hessian(2, 0) += xn;
    sum.hessian(2, 1) += yn;
    sum.hessian(2, 2) += nx * xn + ny * yn;
    const double fx = -weight * cells_per_m * toward.x(), fy = -weight * cells_per_m * toward.y();
    sum.gradient += Eigen::Vector3d(fx, fy, nx * fx + ny * fy);
    sum.inliers += weight;
  }
  sum.hessian.triangularView<Eigen::StrictlyUpper>() = sum.hessian.transpose();
  return sum;
}

}  // namespace

GaussNewton::GaussNewton(const Options& options, const EndpointModel::Options& model_options)
    : options_(options), model_options_(model_options) {
  CHECK_GE(options.max_iterations, 1);
  CHECK_GT(options.noise_sigma_m, 0.0);
  CHECK_GT(options.robust_sigmas, 0.0);
}

GaussNewton::Alignment GaussNewton::Align(const map::OccupancyGrid& grid, const ScanPoints& points,
                                          const SE2& initial_world_T_robot,
                                          const Eigen::Matrix3d& prior_information) const {
  std::vector<map::CellBlock> blocks(points.size());
  Alignment alignment{.world_T_robot = initial_world_T_robot};
  SE2& pose = alignment.world_T_robot;
  for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
    const NormalEquations sum =
        Linearize(grid, points, pose, options_.noise_sigma_m, options_.robust_sigmas, &blocks);
    alignment.world_information = sum.hessian;
    alignment.inliers = sum.inliers;
    const Eigen::Vector3d from_initial(
        pose.x - initial_world_T_robot.x, pose.y - initial_world_T_robot.y,
        backend::WrapAngle(pose.theta - initial_world_T_robot.theta));
    const Eigen::Vector3d step = (sum.hessian + prior_information)
                                     .ldlt()
                                     .solve(-sum.gradient - prior_information * from_initial);
    if (!step.allFinite()) break;
    pose = {pose.x + step.x(), pose.y + step.y(), backend::WrapAngle(pose.theta + step.z())};
    if (step.cwiseAbs().maxCoeff() < options_.step_tolerance) break;
  }
  return alignment;
}

MatchResult GaussNewton::Match(const map::OccupancyGrid& grid, const ScanPoints& points,
                               const SE2& initial_world_T_robot) const {
  return Match(grid, points, initial_world_T_robot, WeakPrior());
}

MatchResult GaussNewton::Match(const map::OccupancyGrid& grid, const ScanPoints& points,
                               const SE2& initial_world_T_robot,
                               const Eigen::Matrix3d& prior_information) const {
  const SE2 aligned = Align(grid, points, initial_world_T_robot, prior_information).world_T_robot;
  EndpointModel model(model_options_, &grid, &points);
  const double initial_score = model.Score(initial_world_T_robot);
  const double aligned_score = model.Score(aligned, initial_score);
  const bool better = aligned_score > initial_score;
  const double score = std::max(aligned_score, initial_score);
  return {score >= options_.min_score && !points.empty(), better ? aligned : initial_world_T_robot,
          score};
}

Eigen::Matrix3d GaussNewton::InformationAt(const map::OccupancyGrid& grid, const ScanPoints& points,
                                           const SE2& world_T_robot) const {
  std::vector<map::CellBlock> blocks(points.size());
  return Linearize(grid, points, world_T_robot, options_.noise_sigma_m, options_.robust_sigmas,
                   &blocks)
      .hessian;
}

}  // namespace gmapping_spa::scan_matching
