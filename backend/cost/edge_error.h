// SPDX-License-Identifier: BSD-3-Clause
// The error of one edge and its derivatives, shared by every solver.
#ifndef GMAPPING_SPA_BACKEND_COST_EDGE_ERROR_H_
#define GMAPPING_SPA_BACKEND_COST_EDGE_ERROR_H_

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "backend/cost/robust_loss.h"
#include "backend/graph/pose_graph.h"
#include "backend/se2.h"

namespace gmapping_spa::backend {

// The error of the measurement i_T_j: e = (R_i' (t_j - t_i) - t_ij, wrap(theta_j - theta_i -
// theta_ij)), m and rad, translation in frame i. That of Konolige et al. 2010, eq. (1), and of .g2o
// files' information (g2o itself turns the error into the frame of the measurement's end).
inline Eigen::Vector3d EdgeError(const SE2& world_T_i, const SE2& world_T_j, const SE2& i_T_j) {
  return Minus(Between(world_T_i, world_T_j), i_T_j);
}

// Cosine and sine of a node's angle, which all of its edges need.
struct Heading {
  double cos = 1.0;
  double sin = 0.0;
};

inline Heading HeadingOf(const SE2& pose) { return {std::cos(pose.theta), std::sin(pose.theta)}; }

// The same error, with the heading of node i.
inline Eigen::Vector3d EdgeError(const SE2& world_T_i, const Heading& heading_i,
                                 const SE2& world_T_j, const SE2& i_T_j) {
  const double dx = world_T_j.x - world_T_i.x, dy = world_T_j.y - world_T_i.y;
  return {heading_i.cos * dx + heading_i.sin * dy - i_T_j.x,
          -heading_i.sin * dx + heading_i.cos * dy - i_T_j.y,
          WrapAngle(world_T_j.theta - world_T_i.theta - i_T_j.theta)};
}

// An error with its Jacobians in the coordinates (x, y, theta) of the two poses, which optimizers
// change by addition.
struct LinearizedEdge {
  Eigen::Vector3d error;
  Eigen::Matrix3d jacobian_i;
  Eigen::Matrix3d jacobian_j;
};

inline LinearizedEdge LinearizeEdge(const SE2& world_T_i, const SE2& world_T_j, const SE2& i_T_j) {
  const double c = std::cos(world_T_i.theta), s = std::sin(world_T_i.theta);
  const double dx = world_T_j.x - world_T_i.x, dy = world_T_j.y - world_T_i.y;
  const double x = c * dx + s * dy, y = -s * dx + c * dy;
  LinearizedEdge edge;
  edge.error = Minus({x, y, world_T_j.theta - world_T_i.theta}, i_T_j);
  edge.jacobian_i << -c, -s, y, s, -c, -x, 0.0, 0.0, -1.0;
  edge.jacobian_j << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
  return edge;
}

// The loss that an edge is subject to: odometry and matches of consecutive scans are trusted.
inline Loss LossOfEdge(const Edge& edge, const Loss& loss) {
  return edge.kind == EdgeKind::kLoopClosure ? loss : Loss{};
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_COST_EDGE_ERROR_H_
