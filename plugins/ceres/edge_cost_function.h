// SPDX-License-Identifier: BSD-3-Clause
// One edge of a pose graph as Ceres sees it.
#ifndef GMAPPING_SPA_PLUGINS_CERES_EDGE_COST_FUNCTION_H_
#define GMAPPING_SPA_PLUGINS_CERES_EDGE_COST_FUNCTION_H_

#include <ceres/sized_cost_function.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "backend/cost/edge_error.h"

namespace gmapping_spa::ceres_backend {

// A square root S of a positive semidefinite information matrix: S' S = information.
inline Eigen::Matrix3d SquareRootInformation(const Eigen::Matrix3d& information) {
  const Eigen::LLT<Eigen::Matrix3d> cholesky(information);
  if (cholesky.info() == Eigen::Success) return cholesky.matrixU();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(information);
  return eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

// The error of backend::LinearizeEdge, whitened, as a function of two poses (x, y, theta).
class EdgeCostFunction : public ::ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit EdgeCostFunction(const backend::Edge& edge)
      : i_T_j_(edge.i_T_j), root_(SquareRootInformation(edge.information)) {}

  bool Evaluate(double const* const* poses, double* residuals, double** jacobians) const override {
    const backend::SE2 world_T_i{poses[0][0], poses[0][1], poses[0][2]};
    const backend::SE2 world_T_j{poses[1][0], poses[1][1], poses[1][2]};
    const backend::LinearizedEdge edge = backend::LinearizeEdge(world_T_i, world_T_j, i_T_j_);
    Eigen::Map<Eigen::Vector3d>(residuals).noalias() = root_ * edge.error;
    if (jacobians == nullptr) return true;
    using JacobianMap = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
    if (jacobians[0] != nullptr) JacobianMap(jacobians[0]).noalias() = root_ * edge.jacobian_i;
    if (jacobians[1] != nullptr) JacobianMap(jacobians[1]).noalias() = root_ * edge.jacobian_j;
    return true;
  }

 private:
  backend::SE2 i_T_j_;
  Eigen::Matrix3d root_;
};

}  // namespace gmapping_spa::ceres_backend

#endif  // GMAPPING_SPA_PLUGINS_CERES_EDGE_COST_FUNCTION_H_
