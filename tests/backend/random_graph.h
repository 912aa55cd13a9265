// SPDX-License-Identifier: BSD-3-Clause
// Random pose graphs for property tests.
#ifndef GMAPPING_SPA_TESTS_BACKEND_RANDOM_GRAPH_H_
#define GMAPPING_SPA_TESTS_BACKEND_RANDOM_GRAPH_H_

#include <random>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

struct RandomGraphOptions {
  int nodes = 30;
  int loop_closures = 20;
  double measurement_noise = 0.05;  // standard deviation, m and rad
  double pose_noise = 0.1;          // of the given poses
};

// A random walk with measurements of random positive definite information. Same seed, same graph.
inline PoseGraph RandomGraph(unsigned seed, const RandomGraphOptions& options = {}) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto noisy = [&](const SE2& pose, double sigma) {
    return pose * SE2{sigma * normal(random), sigma * normal(random), sigma * normal(random)};
  };
  std::vector<SE2> truth;
  PoseGraph graph;
  for (int k = 0; k < options.nodes; ++k) {
    truth.push_back(k == 0 ? SE2{} : noisy(truth.back() * SE2{1.0, 0.0, 0.3}, 0.3));
    graph.nodes.push_back({k, 0.1 * k, noisy(truth.back(), options.pose_noise)});
  }
  const auto add_edge = [&](int i, int j, EdgeKind kind) {
    Eigen::Matrix3d root;
    for (double& entry : root.reshaped()) entry = normal(random);
    graph.edges.push_back({i, j, noisy(Between(truth[i], truth[j]), options.measurement_noise),
                           100.0 * (root * root.transpose() + Eigen::Matrix3d::Identity()), kind});
  };
  for (int k = 0; k + 1 < options.nodes; ++k) add_edge(k, k + 1, EdgeKind::kOdometry);
  std::uniform_int_distribution<int> any(0, options.nodes - 1);
  for (int k = 0; k < options.loop_closures; ++k) {
    const int i = any(random), j = any(random);
    if (i != j) add_edge(i, j, EdgeKind::kLoopClosure);
  }
  return graph;
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_TESTS_BACKEND_RANDOM_GRAPH_H_
