// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/gauss_newton.h"

#include <glog/logging.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "frontend/map/beam_blocks.h"
#include "frontend/map/cell_block.h"
#include "frontend/scan_matching/local_surface.h"
#include "frontend/scan_matching/weakest_direction.h"

namespace gmapping_spa::scan_matching {

using backend::SE2;
using map::CellIndex;
using map::FloorToCell;

namespace {

constexpr float kSingleHit = 1e-4f;  // in squared cells, beyond rounding

// A direction bound by less than this many times what noise feigns is not bound, one bound by twice
// that is.
constexpr double kFeigned = 2.0;
// Variance of the normal of hit means, rad^2.
constexpr double kMapNormalVariance = 0.01;
constexpr double kMeansOfSurface = 3.0;  // hit means that a LocalSurface is made of, about
// The map knows how a wall runs where so many cells around have been hit often.
constexpr int kCellsOfWall = 2;

struct NormalEquations {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double inliers = 0.0;
  // Part of the hessian of (x, y) that normals off by their noise are expected to feign.
  Eigen::Matrix2d feigned = Eigen::Matrix2d::Zero();

  double kept = 1.0;  // part of what the direction that is bound least has

  void KeepWhatIsBound();
};

// Takes out the direction that the scan binds least, as far as it may be the noise of the normals
// that binds it: a corridor of noisy walls would hold the robot where it was last.
void NormalEquations::KeepWhatIsBound() {
  if (!(hessian(2, 2) > 0.0)) return;
  const auto [weakest, bound] = FindWeakestDirection(hessian);
  const double noise = weakest.dot(feigned * weakest);
  kept = bound > 0.0 ? std::clamp(1.0 - kFeigned * noise / bound, 0.0, 1.0) : 0.0;
  Eigen::Matrix3d project = Eigen::Matrix3d::Identity();
  project.topLeftCorner<2, 2>() -= (1.0 - kept) * weakest * weakest.transpose();
  hessian = project * hessian * project;
  hessian.triangularView<Eigen::StrictlyUpper>() = hessian.transpose();
  gradient = project * gradient;
}

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

using Trust = GaussNewton::Trust;

// Of the normal of hit means, rad^2.
double MapNormalVariance(const LocalSurface& surface, Trust trust) {
  if (trust == Trust::kUsual) return kMapNormalVariance;
  const double middle = 0.5 * surface.covariance.trace();
  const double half_gap =
      std::sqrt(std::max(middle * middle - surface.covariance.determinant(), 0.0));
  const double scatter = (middle - half_gap) / (middle + half_gap);
  return std::max(kMapNormalVariance, scatter / kMeansOfSurface);
}

// Of the beams at `pose`, in metres.
NormalEquations Linearize(const map::OccupancyGrid& grid, const ScanPoints& points, const SE2& pose,
                          double noise_sigma_m, double robust_sigmas, map::BeamBlocks* blocks,
                          Trust trust = Trust::kUsual) {
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
    const map::CellBlock& block = blocks->Around(grid, k, cell);
    LocalSurface surface;
    if (!surface.Fit(block, cell, x, y)) continue;
    Eigen::Matrix2f information;
    const Eigen::Vector2f normal(static_cast<float>(c * point.normal_x - s * point.normal_y),
                                 static_cast<float>(s * point.normal_x + c * point.normal_y));
    const bool by_scan = normal.squaredNorm() > 0.5f && block.CountOftenHit(cell) < kCellsOfWall;
    if (by_scan) {
      information = normal * normal.transpose() /
                    (noise_cells * noise_cells + normal.dot(surface.covariance * normal));
    } else if (surface.covariance.trace() < kSingleHit) {
      continue;
    } else {
      information = AcrossWall(surface, noise_cells);
    }
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
    const double variance = by_scan ? point.normal_variance : MapNormalVariance(surface, trust);
    sum.feigned(0, 0) += variance * yy;
    sum.feigned(1, 0) -= variance * xy;
    sum.feigned(1, 1) += variance * xx;
  }
  sum.hessian.triangularView<Eigen::StrictlyUpper>() = sum.hessian.transpose();
  sum.feigned(0, 1) = sum.feigned(1, 0);
  sum.KeepWhatIsBound();
  return sum;
}

}  // namespace

GaussNewton::GaussNewton(const Options& options) : options_(options) {
  CHECK_GE(options.max_iterations, 1);
  CHECK_GT(options.noise_sigma_m, 0.0);
  CHECK_GT(options.robust_sigmas, 0.0);
}

GaussNewton::Alignment GaussNewton::Align(const map::OccupancyGrid& grid, const ScanPoints& points,
                                          const SE2& initial_world_T_robot,
                                          const Eigen::Matrix3d& prior_information,
                                          Trust trust) const {
  map::BeamBlocks blocks(points.size());
  Alignment alignment{.world_T_robot = initial_world_T_robot};
  SE2& pose = alignment.world_T_robot;
  for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
    const NormalEquations sum = Linearize(grid, points, pose, options_.noise_sigma_m,
                                          options_.robust_sigmas, &blocks, trust);
    alignment.world_information = sum.hessian;
    alignment.inliers = sum.inliers;
    const Eigen::Vector3d from_initial = Minus(pose, initial_world_T_robot);
    const Eigen::Vector3d step = (sum.hessian + prior_information)
                                     .ldlt()
                                     .solve(-sum.gradient - prior_information * from_initial);
    if (!step.allFinite()) break;
    pose = Plus(pose, step);
    if (step.cwiseAbs().maxCoeff() < options_.step_tolerance) break;
  }
  return alignment;
}

Eigen::Matrix3d GaussNewton::InformationAt(const map::OccupancyGrid& grid, const ScanPoints& points,
                                           const SE2& world_T_robot) const {
  map::BeamBlocks blocks(points.size());
  return Linearize(grid, points, world_T_robot, options_.noise_sigma_m, options_.robust_sigmas,
                   &blocks)
      .hessian;
}

bool GaussNewton::TellsPosition(const map::OccupancyGrid& grid, const ScanPoints& points,
                                const SE2& world_T_robot) const {
  map::BeamBlocks blocks(points.size());
  const NormalEquations sum = Linearize(grid, points, world_T_robot, options_.noise_sigma_m,
                                        options_.robust_sigmas, &blocks, Trust::kLeast);
  return sum.kept > 0.0 && FindWeakestDirection(sum.hessian).information > 0.0;
}

}  // namespace gmapping_spa::scan_matching
