// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/covariance_table.h"

#include <ctime>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "backend/scheduling/covariances.h"
#include "backend/text.h"

namespace gmapping_spa::apps {
namespace {

using backend::EdgeNodes;
using Kind = CovarianceChoice::Kind;

// Positions of the nodes that the choice names.
std::vector<EdgeNodes> Positions(const CovarianceChoice& choice, const backend::PoseGraph& graph) {
  const int count = static_cast<int>(graph.nodes.size());
  std::vector<EdgeNodes> positions;
  if (choice.kind == Kind::kAll) {
    for (int k = 0; k < count; ++k) positions.push_back({k, k});
    return positions;
  }
  std::unordered_map<std::int64_t, int> position_of_id;
  for (int k = 0; k < count; ++k) position_of_id.emplace(graph.nodes[k].id, k);
  const auto position_of = [&](std::int64_t id) {
    const auto found = position_of_id.find(id);
    if (found != position_of_id.end()) return found->second;
    throw std::runtime_error("--covariances_of: the graph has no node " + std::to_string(id));
  };
  for (const auto& [i, j] : choice.ids) positions.push_back({position_of(i), position_of(j)});
  return positions;
}

// What is known of two components is known by fixed nodes alone; one that has none floats.
void CheckConnected(const backend::PoseGraph& graph, const std::vector<int>& component,
                    const std::vector<EdgeNodes>& pairs) {
  std::vector<bool> has_fixed(graph.nodes.size(), false);
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    if (graph.nodes[k].fixed) has_fixed[component[k]] = true;
  }
  for (const auto& [i, j] : pairs) {
    const int a = component[i], b = component[j];
    if (a == b || (has_fixed[a] && has_fixed[b])) continue;
    throw std::runtime_error(
        "--covariances_of: nothing connects the nodes " + std::to_string(graph.nodes[i].id) +
        " and " + std::to_string(graph.nodes[j].id) + ": their relative pose has no covariance");
  }
}

// For each component, by its first node, the first node in it that is held.
std::vector<int> HeldNodes(const backend::GraphIndex& index, const std::vector<int>& component) {
  std::vector<int> held(component.size(), -1);
  for (std::size_t k = 0; k < component.size(); ++k) {
    int& of_component = held[component[k]];
    if (index.fixed[k] && of_component < 0) of_component = static_cast<int>(k);
  }
  return held;
}

void WriteMatrix(const Eigen::Matrix3d& matrix, bool upper_triangle, std::ostream& out) {
  for (int a = 0; a < 3; ++a) {
    for (int b = upper_triangle ? a : 0; b < 3; ++b) {
      out << ',' << backend::ShortestText(matrix(a, b));
    }
  }
}

std::string EdgesUsed(const CovarianceTable& table) {
  std::ostringstream text;
  text << table.edges_used << " of " << table.edges << " edges, weighted as the loss " << table.loss
       << " left them";
  if (table.variance_factor != 1.0) {
    text << ", with " << backend::ShortestText(table.variance_factor)
         << " times the covariance that loop closures say";
  }
  return text.str();
}

}  // namespace

CovarianceTable MakeCovarianceTable(const backend::PoseGraph& graph, const CovarianceChoice& choice,
                                    const backend::Loss& loss, const backend::Summary& summary,
                                    backend::Optimizer* optimizer) {
  const backend::PoseGraph used{graph.nodes, backend::EdgesOfResult(loss, graph.edges, summary)};
  const backend::GraphIndex index = backend::IndexGraph(used);
  const std::vector<int> component = backend::ComponentsOf(index);
  const std::vector<int> held = HeldNodes(index, component);
  const std::vector<EdgeNodes> chosen = Positions(choice, graph);

  CovarianceTable table;
  table.of_pairs = choice.kind == Kind::kPairs;
  table.loss = backend::LossKindName(loss.kind);
  table.variance_factor = summary.variance_factor;
  table.edges = graph.edges.size();
  table.edges_used = used.edges.size();
  for (std::size_t k = 0; k < component.size(); ++k) {
    table.components += component[k] == static_cast<int>(k) ? 1 : 0;
  }
  table.by_back_end = optimizer->HasCovariances();

  std::vector<EdgeNodes> asked;
  for (const auto& [i, j] : chosen) {
    asked.push_back({i, i});
    if (table.of_pairs) asked.insert(asked.end(), {{i, j}, {j, j}});
  }
  if (table.of_pairs) CheckConnected(graph, component, chosen);
  const std::clock_t start = std::clock();
  const std::vector<Eigen::Matrix3d> covariances = backend::Covariances(used, asked, optimizer);
  table.cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;

  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const auto [i, j] = chosen[k];
    const backend::SE2 &world_T_i = graph.nodes[i].world_T_node,
                       &world_T_j = graph.nodes[j].world_T_node;
    if (!table.of_pairs) {
      table.rows.push_back({.i = graph.nodes[held[component[j]]].id,
                            .j = graph.nodes[j].id,
                            .pose = world_T_j,
                            .covariance = covariances[k]});
      continue;
    }
    const Eigen::Matrix3d &ii = covariances[3 * k], &ij = covariances[3 * k + 1],
                          &jj = covariances[3 * k + 2];
    table.rows.push_back(
        {.i = graph.nodes[i].id,
         .j = graph.nodes[j].id,
         .pose = backend::Between(world_T_i, world_T_j),
         .covariance = backend::RelativeCovariance(world_T_i, world_T_j, ii, ij, jj),
         .cross_covariance = ij});
  }
  return table;
}

void WriteCovariances(const CovarianceTable& table, std::ostream& out) {
  if (table.of_pairs) {
    out << "# Pose (x, y, theta) of node j in the frame of node i and its covariance, x and y "
           "along the axes of frame i; cross_ab is the covariance of a of node i and b of node j "
           "in the world frame, where the held nodes have none";
  } else {
    out << "# Pose (x, y, theta) of each node in the world frame and its covariance, x and y along "
           "the axes of the world frame, relative to the held nodes of its component (held_node "
           "is the first of them), which have none";
  }
  out << "; errors are added to coordinates, not composed; m, rad, m^2, m rad, rad^2; to first "
         "order, from "
      << EdgesUsed(table) << "\n"
      << (table.of_pairs ? "i,j" : "node,held_node")
      << ",x_m,y_m,theta_rad,cov_xx,cov_xy,cov_xtheta,cov_yy,cov_ytheta,cov_thetatheta";
  if (table.of_pairs) {
    out << ",cross_xx,cross_xy,cross_xtheta,cross_yx,cross_yy,cross_ytheta,cross_thetax,"
           "cross_thetay,cross_thetatheta";
  }
  out << '\n';
  for (const CovarianceTable::Row& row : table.rows) {
    const auto [first, second] = table.of_pairs ? std::pair(row.i, row.j) : std::pair(row.j, row.i);
    out << first << ',' << second << ',' << backend::ShortestText(row.pose.x) << ','
        << backend::ShortestText(row.pose.y) << ',' << backend::ShortestText(row.pose.theta);
    WriteMatrix(row.covariance, true, out);
    if (table.of_pairs) WriteMatrix(row.cross_covariance, false, out);
    out << '\n';
  }
}

nlohmann::ordered_json ToJson(const CovarianceTable& table) {
  return {{"of", table.of_pairs ? "pairs" : "nodes"},
          {"rows", table.rows.size()},
          {"computed_by", table.by_back_end ? "back end" : "program"},
          {"edges_used", EdgesUsed(table)},
          {"components", table.components},
          {"cpu_s", table.cpu_s}};
}

}  // namespace gmapping_spa::apps
