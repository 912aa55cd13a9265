// SPDX-License-Identifier: BSD-3-Clause
// The Lagrangian dual of a pose graph's quadratic lower bound.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_DUAL_PROBLEM_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_DUAL_PROBLEM_H_

#include <Eigen/Core>
#include <vector>

#include "backend/certificate/edge_bound.h"
#include "backend/certificate/information_split.h"
#include "backend/graph/pose_graph.h"
#include "backend/sparse/block_matrix.h"
#include "backend/sparse/graph_structure.h"

namespace gmapping_spa::backend {

// Position and rotation of a node as (x, y, cos theta, sin theta).
using LiftedMatrix = spa::BlockMatrix<4>;
using LiftedVector = LiftedMatrix::Vector;

// With y the positions and rotations of the free nodes (held ones are constants), y0 those of the
// given poses, f the cost and w = y - y0, the sum of all edges' bounds is, wherever rotations have
// length 1,
//   f(y) >= f(y0) - slack + gradient' w + 1/2 w' S w,
// where S is the second derivative of the bounds minus a multiplier for each rotation's length.
// Where S is positive definite, no poses cost less than f(y0) - slack - 1/2 gradient' S^-1
// gradient: the certificate matrix of Carlone et al. 2016, with the gauge fixed.
struct DualProblem {
  LiftedMatrix matrix;  // S
  LiftedVector gradient;
  double slack = 0.0;
};

// `splits` and `tangents` (see EdgeBound) have one entry for each edge, `poses` one for each node.
DualProblem MakeDualProblem(const PoseGraphView& graph, const spa::GraphStructure& structure,
                            const std::vector<InformationSplit>& splits,
                            const std::vector<SE2>& poses,
                            const std::vector<Eigen::Vector3d>& tangents);

// Adds the second derivative of an edge's quadratic function: tau, b and h of EdgeBound, and what
// each rotation has on the diagonal.
void AddEdge(const spa::BlockStructure& structure, std::size_t edge, EdgeNodes nodes,
             const EdgeBound& bound, double stiffness_i, double stiffness_j, LiftedMatrix* matrix);

// The product of the matrix with a vector.
LiftedVector Multiply(const spa::BlockStructure& structure, const LiftedMatrix& matrix,
                      const LiftedVector& x);

double Dot(const LiftedVector& x, const LiftedVector& y);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_DUAL_PROBLEM_H_
