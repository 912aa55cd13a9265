// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of GaussNewton from their definition, for comparison.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_SCAN_MATCHING_NORMAL_EQUATIONS_H_
#define GMAPPING_SPA_TESTS_FRONTEND_SCAN_MATCHING_NORMAL_EQUATIONS_H_

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// The occupied cells (of the default threshold, 0.1) around a point, weighted by the window: mean
// and covariance, in metres.
struct Surface {
  double weight = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  int often_hit = 0;  // cells that were hit eight times or more
};

inline Surface SurfaceAt(const map::OccupancyGrid& grid, const Eigen::Vector2d& point_m) {
  const double resolution_m = grid.resolution_m();
  const int x = static_cast<int>(std::floor(point_m.x() / resolution_m));
  const int y = static_cast<int>(std::floor(point_m.y() / resolution_m));
  Surface surface;
  for (int at_x = x - 1; at_x <= x + 1; ++at_x) {
    for (int at_y = y - 1; at_y <= y + 1; ++at_y) {
      const map::Cell& cell = grid.cell({at_x, at_y});
      if (!(cell.hits > 0.1 * cell.visits)) continue;
      if (cell.hits >= 8) ++surface.often_hit;
      const Eigen::Vector2d hit = resolution_m * Eigen::Vector2d(at_x + cell.mean_x / 65536.0,
                                                                 at_y + cell.mean_y / 65536.0);
      const double d = (hit - point_m).norm() / (2.0 * resolution_m);
      const double weight = d < 1.0 ? std::pow(1.0 - d * d, 2) : 0.0;
      surface.weight += weight;
      surface.mean += weight * hit;
      surface.covariance += weight * (hit - point_m) * (hit - point_m).transpose();
    }
  }
  if (surface.weight == 0.0) return surface;
  surface.mean /= surface.weight;
  surface.covariance /= surface.weight;
  surface.covariance -= (surface.mean - point_m) * (surface.mean - point_m).transpose();
  return surface;
}

// The robust normal equations, beam by beam from the cells of the map; the end points'
// derivatives by central differences.
struct Reference {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double inliers = 0.0;
  Eigen::Matrix2d feigned = Eigen::Matrix2d::Zero();  // what turned normals would bind
};

// Less what the noise of the normals may feign, twice over, of the direction bound least.
inline void KeepWhatIsBound(Reference* sum) {
  const Eigen::Matrix2d position = sum->hessian.inverse().topLeftCorner<2, 2>().inverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(position);
  const Eigen::Vector2d weakest = axes.eigenvectors().col(0);
  const double noise = weakest.dot(sum->feigned * weakest);
  const double kept = std::max(0.0, 1.0 - 2.0 * noise / axes.eigenvalues()[0]);
  Eigen::Matrix3d project = Eigen::Matrix3d::Identity();
  project.topLeftCorner<2, 2>() -= (1.0 - kept) * weakest * weakest.transpose();
  sum->hessian = project * sum->hessian * project;
  sum->gradient = project * sum->gradient;
}

// Inverse covariance of the end point's distance to the surface across the normal that the scan
// itself has there; where it has none, of the surface of the map.
inline Eigen::Matrix2d Information(const Surface& surface, const Eigen::Vector2d& normal,
                                   double noise_m) {
  if (normal.norm() > 0.5) {
    return normal * normal.transpose() /
           (noise_m * noise_m + normal.dot(surface.covariance * normal));
  }
  // Across a wall all of the information counts, along it (the larger variance) hardly any.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
      surface.covariance + noise_m * noise_m * Eigen::Matrix2d::Identity());
  const double ratio = axes.eigenvalues()[0] / axes.eigenvalues()[1];
  const Eigen::Vector2d kept(1.0, std::pow(ratio, 4));
  return axes.eigenvectors() * kept.cwiseQuotient(axes.eigenvalues()).asDiagonal() *
         axes.eigenvectors().transpose();
}

inline Reference NormalEquations(const map::OccupancyGrid& grid, const ScanPoints& points,
                                 const backend::SE2& pose, const GaussNewton::Options& options) {
  Reference sum;
  for (const ScanPoint& point : points) {
    const auto end = [&](const Eigen::Vector3d& d) -> Eigen::Vector2d {
      return backend::SE2{pose.x + d.x(), pose.y + d.y(), pose.theta + d.z()} *
             Eigen::Vector2d(point.x_m, point.y_m);
    };
    const Surface surface = SurfaceAt(grid, end(Eigen::Vector3d::Zero()));
    if (surface.weight == 0.0) continue;
    Eigen::Vector2d normal =
        backend::SE2{0, 0, pose.theta} * Eigen::Vector2d(point.normal_x, point.normal_y);
    if (surface.often_hit >= 2) normal.setZero();  // the map knows better
    const bool has_normal = normal.norm() > 0.5;
    if (!has_normal && surface.covariance.trace() < 2.5e-7) continue;  // a single hit
    Eigen::Matrix<double, 2, 3> jacobian;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d d = 1e-5 * Eigen::Vector3d::Unit(i);
      jacobian.col(i) = (end(d) - end(-d)) / 2e-5;
    }
    const Eigen::Matrix2d information = Information(surface, normal, options.noise_sigma_m);
    const Eigen::Vector2d error = end(Eigen::Vector3d::Zero()) - surface.mean;
    const double squared = error.dot(information * error);
    const double weight = 1.0 / (1.0 + squared / std::pow(options.robust_sigmas, 2));
    sum.hessian += weight * jacobian.transpose() * information * jacobian;
    sum.gradient += weight * jacobian.transpose() * information * error;
    sum.inliers += weight;
    const double variance = has_normal ? point.normal_variance : 0.01;
    const Eigen::Matrix2d quarter_turn = Eigen::Rotation2Dd(std::numbers::pi / 2).matrix();
    sum.feigned += weight * variance * quarter_turn * information * quarter_turn.transpose();
  }
  KeepWhatIsBound(&sum);
  return sum;
}

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_TESTS_FRONTEND_SCAN_MATCHING_NORMAL_EQUATIONS_H_
