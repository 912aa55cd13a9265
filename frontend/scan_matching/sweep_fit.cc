// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/sweep_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

#include "frontend/map/beam_blocks.h"
#include "frontend/scan_matching/local_surface.h"

namespace gmapping_spa::scan_matching {

using backend::SE2;
using map::FloorToCell;

namespace {

// The pose is known roughly, and the duration is that of a laser.
const Eigen::Vector4d kPriorInformation(1.0 / (0.1 * 0.1), 1.0 / (0.1 * 0.1), 1.0 / (0.1 * 0.1),
                                        1.0 / (0.1 * 0.1));

// Of (x, y, theta) in the robot frame and the duration.
struct NormalEquations {
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  double inliers = 0.0;
};

NormalEquations Linearize(const map::OccupancyGrid& grid, const ScanPoints& points,
                          const Eigen::Vector3d& velocity, const SweepFit& at,
                          const GaussNewton::Options& options, map::BeamBlocks* blocks) {
  const double cells_per_m = 1.0 / grid.resolution_m();
  NormalEquations sum;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ScanPoint& point = points[k];
    const SE2 deskew = backend::Exp(point.in_sweep * at.sweep_s * velocity);
    const Eigen::Vector2d end = deskew * Eigen::Vector2d(point.x_m, point.y_m);
    const Eigen::Vector2d in_cells = cells_per_m * (at.world_T_robot * end);
    const map::CellIndex cell{FloorToCell(in_cells.x()), FloorToCell(in_cells.y())};
    LocalSurface surface;
    if (!surface.Fit(blocks->Around(grid, k, cell), cell, in_cells.x(), in_cells.y())) continue;
    const Eigen::Vector2d normal =
        Eigen::Rotation2Dd(deskew.theta) * Eigen::Vector2d(point.normal_x, point.normal_y);
    if (normal.squaredNorm() < 0.5) continue;
    const Eigen::Vector2f across =
        (Eigen::Rotation2Dd(at.world_T_robot.theta) * normal).cast<float>();
    const double error_m = -surface.offset.dot(across) / cells_per_m;
    const double variance_m2 =
        options.noise_sigma_m * options.noise_sigma_m +
        across.dot(surface.covariance * across) / (cells_per_m * cells_per_m);
    const double weight =
        1.0 /
        (1.0 + error_m * error_m / (variance_m2 * options.robust_sigmas * options.robust_sigmas));
    const auto moved_by = [&](const Eigen::Vector3d& twist) {
      return normal.dot(
          Eigen::Vector2d(twist.x() - twist.z() * end.y(), twist.y() + twist.z() * end.x()));
    };
    const Eigen::Vector4d derivative(normal.x(), normal.y(), moved_by(Eigen::Vector3d::UnitZ()),
                                     point.in_sweep * moved_by(velocity));
    sum.hessian += weight / variance_m2 * derivative * derivative.transpose();
    sum.gradient += weight / variance_m2 * error_m * derivative;
    sum.inliers += weight;
  }
  return sum;
}

}  // namespace

SweepFit FitSweep(const map::OccupancyGrid& grid, const ScanPoints& points,
                  const Eigen::Vector3d& velocity, const SweepFit& initial,
                  const GaussNewton::Options& options) {
  map::BeamBlocks blocks(points.size());
  SweepFit fit = initial;
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const NormalEquations sum = Linearize(grid, points, velocity, fit, options, &blocks);
    fit.inliers = sum.inliers;
    Eigen::Matrix4d hessian = sum.hessian;
    hessian.diagonal() += kPriorInformation;
    Eigen::Vector4d from_initial;
    from_initial << backend::Log(Between(initial.world_T_robot, fit.world_T_robot)),
        fit.sweep_s - initial.sweep_s;
    const Eigen::LDLT<Eigen::Matrix4d> factor = hessian.ldlt();
    fit.information = 1.0 / factor.solve(Eigen::Vector4d::UnitW()).w() - kPriorInformation.w();
    const Eigen::Vector4d step =
        factor.solve(-sum.gradient - kPriorInformation.cwiseProduct(from_initial));
    if (!step.allFinite()) return initial;
    fit.world_T_robot = fit.world_T_robot * backend::Exp(step.head<3>());
    fit.sweep_s += step.w();
    if (step.cwiseAbs().maxCoeff() < options.step_tolerance) break;
  }
  return fit;
}

}  // namespace gmapping_spa::scan_matching
