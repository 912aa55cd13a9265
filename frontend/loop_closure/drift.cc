// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/drift.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>

namespace gmapping_spa::loop_closure {

using backend::SE2;

double DriftModel::SquaredDistance(const SE2& discrepancy, double path_length_m) const {
  return std::pow(discrepancy.translation().norm() / LinearSigma(path_length_m), 2) +
         std::pow(discrepancy.theta / AngularSigma(path_length_m), 2);
}

std::vector<double> WaysDriven(const std::vector<SE2>& world_T_nodes) {
  std::vector<double> ways(world_T_nodes.size(), 0.0);
  for (std::size_t k = 1; k < world_T_nodes.size(); ++k) {
    const Eigen::Vector2d step = Between(world_T_nodes[k - 1], world_T_nodes[k]).translation();
    ways[k] = ways[k - 1] + step.norm();
  }
  return ways;
}

std::vector<double> ShortestWays(const std::vector<double>& ways_driven,
                                 std::span<const backend::Edge> closures, int from) {
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, double>>;
  Graph graph(ways_driven.size());
  for (std::size_t k = 1; k < ways_driven.size(); ++k) {
    boost::add_edge(k - 1, k, ways_driven[k] - ways_driven[k - 1], graph);
  }
  for (const backend::Edge& closure : closures) boost::add_edge(closure.i, closure.j, 0.0, graph);
  std::vector<double> ways(ways_driven.size());
  boost::dijkstra_shortest_paths(graph, from,
                                 boost::distance_map(boost::make_iterator_property_map(
                                     ways.begin(), get(boost::vertex_index, graph))));
  return ways;
}

}  // namespace gmapping_spa::loop_closure
