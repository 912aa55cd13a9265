// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a pose graph, without SLAM: a square that was driven and measured with errors.
#include <gmapping_spa/g2o_io.h>
#include <gmapping_spa/optimize_safely.h>
#include <gmapping_spa/plugin_loader.h>

#include <exception>
#include <iostream>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace backend = gmapping_spa::backend;

int main() try {
  // Each side is measured 10.2 m long, and the way back to the start closes the loop.
  const backend::SE2 side{10.2, 0.0, std::numbers::pi / 2};
  backend::PoseGraph graph;
  graph.nodes.push_back({.id = 0, .world_T_node = {}});
  for (int k = 1; k < 4; ++k) {
    graph.nodes.push_back({.id = k, .world_T_node = graph.nodes.back().world_T_node * side});
    graph.edges.push_back({.i = k - 1, .j = k, .i_T_j = side});
  }
  graph.edges.push_back({.i = 3,
                         .j = 0,
                         .i_T_j = {10.0, 0.0, std::numbers::pi / 2},
                         .kind = backend::EdgeKind::kLoopClosure});

  const std::unique_ptr<backend::Optimizer> spa = backend::LoadOptimizer("spa");
  const backend::Summary summary = backend::OptimizeSafely({}, spa.get(), &graph);
  if (summary.termination != backend::Termination::kConverged) {
    throw std::runtime_error(summary.message);
  }
  std::cerr << "the cost went from " << summary.initial_cost << " to " << summary.final_cost
            << '\n';
  backend::WriteG2o(graph, std::cout);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
