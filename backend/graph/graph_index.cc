// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/graph_index.h"

#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace gmapping_spa::backend {
namespace {

// Finds the position of an id. Ids that count up from the first one, as those of nearly all graphs
// do, need no table.
class Positions {
 public:
  explicit Positions(std::span<const Node> nodes) : size_(static_cast<int>(nodes.size())) {
    if (nodes.empty()) return;
    first_ = nodes.front().id;
    for (int k = 0; k < size_ && counting_; ++k) {
      counting_ = static_cast<std::uint64_t>(nodes[k].id) - static_cast<std::uint64_t>(first_) ==
                  static_cast<std::uint64_t>(k);
    }
    if (counting_) return;
    table_.reserve(nodes.size());
    for (int k = 0; k < size_; ++k) {
      if (!table_.emplace(nodes[k].id, k).second) {
        throw std::invalid_argument("two nodes have the id " + std::to_string(nodes[k].id));
      }
    }
  }

  int Of(std::int64_t id) const {
    if (counting_) {
      const std::uint64_t offset =
          static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(first_);
      if (offset < static_cast<std::uint64_t>(size_)) return static_cast<int>(offset);
    } else if (const auto found = table_.find(id); found != table_.end()) {
      return found->second;
    }
    throw std::invalid_argument("an edge names the node " + std::to_string(id) +
                                ", which does not exist");
  }

 private:
  int size_;
  std::int64_t first_ = 0;
  bool counting_ = true;
  std::unordered_map<std::int64_t, int> table_;
};

// Root of `node` in a forest of parents, halving the path on the way.
int FindRoot(std::vector<int>& parent, int node) {
  while (parent[node] != node) node = parent[node] = parent[parent[node]];
  return node;
}

// Connects the components of two nodes. The smaller root wins, so that a component's root is its
// first node.
void Connect(const EdgeNodes& nodes, std::vector<int>& parent) {
  const int a = FindRoot(parent, nodes.i), b = FindRoot(parent, nodes.j);
  parent[std::max(a, b)] = std::min(a, b);
}

}  // namespace

std::vector<int> ComponentsOf(const GraphIndex& index) {
  std::vector<int> component(index.fixed.size());
  std::iota(component.begin(), component.end(), 0);
  for (const EdgeNodes& nodes : index.edges) Connect(nodes, component);
  for (std::size_t k = 0; k < component.size(); ++k) {
    component[k] = FindRoot(component, static_cast<int>(k));
  }
  return component;
}

GraphIndex IndexGraph(const PoseGraphView& graph) {
  const int node_count = static_cast<int>(graph.nodes.size());
  const Positions positions(graph.nodes);
  GraphIndex index;
  index.edges.reserve(graph.edges.size());
  std::vector<int> parent(node_count);
  std::iota(parent.begin(), parent.end(), 0);
  for (const Edge& edge : graph.edges) {
    const EdgeNodes nodes{positions.Of(edge.i), positions.Of(edge.j)};
    index.edges.push_back(nodes);
    Connect(nodes, parent);
  }

  std::vector<bool> component_has_fixed(node_count, false);
  for (int k = 0; k < node_count; ++k) {
    if (graph.nodes[k].fixed) component_has_fixed[FindRoot(parent, k)] = true;
  }
  index.fixed.resize(node_count);
  for (int k = 0; k < node_count; ++k) {
    const bool first_of_free_component = parent[k] == k && !component_has_fixed[k];
    index.fixed[k] = graph.nodes[k].fixed || first_of_free_component;
  }
  return index;
}

}  // namespace gmapping_spa::backend
