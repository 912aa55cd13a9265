// SPDX-License-Identifier: BSD-3-Clause
// A quadratic function that is nowhere above the cost of an edge.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_EDGE_BOUND_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_EDGE_BOUND_H_

#include <complex>

#include "backend/certificate/information_split.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

using Complex = std::complex<double>;

// With positions t and rotations z (|z| = 1) as complex numbers,
//   m(t, z) = tau/2 |t_j - t_i|^2 - Re(conj(t_j - t_i) z_i b) + Re(conj(z_i) h z_j) + constant
// is at most e' Omega e / 2 for all poses, and equal to it, with the same gradient, where the error
// e is the `tangent`. It is made of two parts, with Omega = diag(tau, tau, w) + P, P positive
// semidefinite (SplitInformation):
//   - Of P, and of the translation, the tangent: e' P e is convex.
//   - Of the angle d, which that leaves as w d^2 + 2 p d, the function a + b cos d + c sin d that
//     touches it at the tangent and has the largest curvature there of all that stay below it for d
//     in [-pi, pi]. With T = w d0 + p, from 0 (else mirrored), and s = d0 - d, that curvature is
//     the smallest value of (w s^2 - 2 T (s - sin s)) / (1 - cos s), which falls up to s = 2 T / w
//     and rises from there.
struct EdgeBound {
  double tau = 0.0;
  Complex b;
  Complex h;

  // At the poses that it was made for:
  Complex force;          // derivative by t_j, in frame i; that by t_i is its opposite
  double torque_i = 0.0;  // derivative by the angle of i
  double torque_j = 0.0;
  // What the edge adds to the Lagrangian's second derivative by z_i and z_j, where |z| = 1 has the
  // multiplier that makes the derivatives by the length of z zero.
  double stiffness_i = 0.0;
  double stiffness_j = 0.0;
  double slack = 0.0;  // cost of the edge minus the bound; from 0
};

// The bound of `edge`, whose node j is at `i_T_j_at_poses` as seen from node i. The angle of the
// tangent is in [-pi, pi]. At pi itself there may be no such bound: some numbers are not finite
// then.
EdgeBound BoundEdge(const Edge& edge, const InformationSplit& split, const SE2& i_T_j_at_poses,
                    const Eigen::Vector3d& tangent);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_EDGE_BOUND_H_
