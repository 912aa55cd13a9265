// SPDX-License-Identifier: BSD-3-Clause
// Whether poses are the global optimum of a pose graph's least squares.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_CERTIFIER_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_CERTIFIER_H_

#include <optional>
#include <vector>

#include "backend/certificate/lifted_solver.h"
#include "backend/graph/pose_graph.h"
#include "backend/sparse/graph_structure.h"
#include "backend/sparse/normal_equations.h"

namespace gmapping_spa::backend {

// A lower bound of the cost of all poses, and how it was come by.
struct Certificate {
  double cost = 0.0;         // 1/2 sum e' Omega e of the poses
  double lower_bound = 0.0;  // no poses cost less; from 0
  // That the poses are the optimum but for this part of the cost, 0 to 1.
  double relative_gap = 1.0;
  // Whether the certificate matrix is positive definite, or becomes so by adding `shift` to the
  // diagonal of each rotation, which lowers the bound by 2 shift for each free node.
  bool positive_definite = false;
  double shift = 0.0;
  double margin = 0.0;  // part of the diagonal that was taken off against rounding
  // Of the matrix, in the metric of the rotations, where it is not positive definite: found by
  // inverse iteration, from above.
  double smallest_eigenvalue = 0.0;

  bool optimal() const;  // the gap is at most kOptimalGap of the cost, or kOptimalCost
};

inline constexpr double kOptimalGap = 1e-6;
// A cost is half a chi-square statistic: what is below this is none.
inline constexpr double kOptimalCost = 1e-9;

// Certifies poses of one graph, whose structure is analysed once. What is proved is proved for the
// cost of GraphCost without a loss, whatever the information matrices: see EdgeBound. For
// information that is far from isotropic, or errors of rotations of a radian and more, the bound
// may be too low to prove anything. Double precision: the tangents, the sums and the positive
// definiteness are those of exact arithmetic up to rounding, for which `margin` is the usual
// estimate of a Cholesky factorization's backward error, epsilon times the number of unknowns times
// the diagonal; it is no enclosure.
class Certifier {
 public:
  // The graph must outlive the object. Throws like IndexGraph.
  explicit Certifier(const PoseGraphView& graph);

  // `poses`: one for each node. Held ones are those of the graph.
  Certificate Certify(const std::vector<SE2>& poses);

  // After a Certify that found the matrix not positive definite: a direction x of the free nodes'
  // positions and rotations with x' S x < 0, with which the bound of *certificate is completed.
  // Nothing when there is none but for rounding.
  std::optional<LiftedVector> NegativeCurvature(Certificate* certificate);

  const PoseGraphView& graph() const { return graph_; }
  const spa::GraphStructure& structure() const { return structure_; }
  const std::vector<InformationSplit>& splits() const { return splits_; }

 private:
  // The errors at the poses that a Gauss-Newton step leads to, to first order: there the forces of
  // the edges are in balance up to rounding, which they need not be at poses of finite precision.
  std::vector<Eigen::Vector3d> Tangents(const std::vector<SE2>& poses);
  // Whether S + shift is positive definite; if so, completes the bound.
  bool TryShift(double shift, Certificate* certificate);

  PoseGraphView graph_;
  spa::GraphStructure structure_;
  std::vector<InformationSplit> splits_;
  DualProblem dual_;
  LiftedSolver solver_;
  spa::NormalEquations equations_;
  spa::SparseCholesky cholesky_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_CERTIFIER_H_
