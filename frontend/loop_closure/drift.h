// SPDX-License-Identifier: BSD-3-Clause
// How uncertain the relative pose of two nodes is.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_DRIFT_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_DRIFT_H_

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "backend/se2.h"

namespace gmapping_spa::loop_closure {

// Standard deviations of a relative pose that was measured along a way. They grow with the way
// itself, not with its root as independent errors would: what scan matching gets wrong in a
// corridor it gets wrong from end to end.
struct DriftModel {
  double floor_m = 0.1;
  double m_per_m = 0.015;
  double floor_rad = 0.02;
  double rad_per_m = 0.0005;

  double LinearSigma(double path_length_m) const { return floor_m + m_per_m * path_length_m; }
  double AngularSigma(double path_length_m) const { return floor_rad + rad_per_m * path_length_m; }

  // Squared Mahalanobis distance of a discrepancy after such a way.
  double SquaredDistance(const backend::SE2& discrepancy, double path_length_m) const;
  friend bool operator==(const DriftModel&, const DriftModel&) = default;
};

// Stands for the way between two pieces of the path that nothing is known between: after so long a
// way drift explains any pose. Longer than any way driven.
inline constexpr double kUnknownWay_m = 1e7;

// Way driven from node 0 up to each node.
std::vector<double> WaysDriven(const std::vector<backend::SE2>& world_T_nodes);

// Length of the shortest way from node `from` to each node, over the path driven and over
// `closures`, which are no way at all.
std::vector<double> ShortestWays(const std::vector<double>& ways_driven,
                                 std::span<const backend::Edge> closures, int from);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_DRIFT_H_
