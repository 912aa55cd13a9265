// SPDX-License-Identifier: BSD-3-Clause
// The chordal cost of poses whose rotations are lifted to more dimensions.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_CHORDAL_COST_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_CHORDAL_COST_H_

#include <Eigen/Core>
#include <vector>

#include "backend/certificate/dual_problem.h"
#include "backend/certificate/edge_bound.h"

namespace gmapping_spa::backend {

// Positions t and rotations z of all nodes as rows of complex numbers, row 2 k and 2 k + 1 for node
// k. Rotations have length 1. With a single column they are poses.
using LiftedPoses = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The row of a node's position; that of its rotation is the next one.
inline Eigen::Index RowOf(std::size_t node) { return 2 * static_cast<Eigen::Index>(node); }

// Poses with `columns` columns, zero but for the first.
LiftedPoses LiftPoses(const std::vector<SE2>& poses, int columns);

// 1/2 sum tau |t_j - t_i - m z_i|^2 + w |z_j - e^(i theta) z_i|^2 over the edges with measurement
// (m, theta) and split (tau, w): the bound of EdgeBound whose tangent is no error. On poses it is
// at most their cost. In the lifted poses it is a quadratic function.
class ChordalCost {
 public:
  // The arguments must outlive the object.
  ChordalCost(const PoseGraphView& graph, const spa::GraphStructure& structure,
              const std::vector<InformationSplit>& splits);

  // The derivative of the cost, half of whose product with the poses is the cost; rows of held
  // nodes are zero when `free_only`.
  LiftedPoses Gradient(const LiftedPoses& poses, bool free_only) const;

  // Its second derivative by the free nodes' positions and rotations.
  LiftedMatrix Matrix() const;

 private:
  struct Weights {
    double tau, w;
    Complex measured, rotation;
  };

  const spa::GraphStructure& structure_;
  std::vector<Weights> weights_;  // of each edge
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_CHORDAL_COST_H_
