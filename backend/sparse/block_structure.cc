// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/block_structure.h"

#include <suitesparse/amd.h>

#include <algorithm>
#include <new>
#include <numeric>

namespace gmapping_spa::spa {
namespace {

using backend::EdgeNodes;
using backend::GraphIndex;

// The pairs of columns that edges from `first_edge` on connect, each once: for each column from
// `first_column` on, its rows in ascending order.
struct Adjacency {
  std::vector<int> begin;
  std::vector<int> row;
};

Adjacency MakeAdjacency(const GraphIndex& index, const std::vector<int>& column_of_node,
                        std::size_t first_edge, int first_column, int columns) {
  const int new_columns = columns - first_column;
  Adjacency adjacency{std::vector<int>(new_columns + 1, 0), std::vector<int>()};
  const auto for_each_pair = [&](const auto& visit) {
    for (std::size_t e = first_edge; e < index.edges.size(); ++e) {
      const int a = column_of_node[index.edges[e].i], b = column_of_node[index.edges[e].j];
      if (a >= 0 && b >= 0 && a != b) visit(std::min(a, b), std::max(a, b) - first_column);
    }
  };
  for_each_pair([&](int, int column) { ++adjacency.begin[column + 1]; });
  for (int k = 0; k < new_columns; ++k) adjacency.begin[k + 1] += adjacency.begin[k];
  adjacency.row.resize(adjacency.begin.back());
  std::vector<int> next(adjacency.begin.begin(), adjacency.begin.end() - 1);
  for_each_pair([&](int row, int column) { adjacency.row[next[column]++] = row; });
  // Columns are short: sort each, and close the gaps that duplicates leave.
  int end = 0;
  for (int k = 0; k < new_columns; ++k) {
    const auto first = adjacency.row.begin() + adjacency.begin[k];
    const auto last = adjacency.row.begin() + next[k];
    std::sort(first, last);
    const auto unique_last = std::unique(first, last);
    std::copy(first, unique_last, adjacency.row.begin() + end);
    adjacency.begin[k] = end;
    end += static_cast<int>(unique_last - first);
  }
  adjacency.begin[new_columns] = end;
  adjacency.row.resize(end);
  return adjacency;
}

// Appends the columns from `first_column` on and the slots of the edges not yet known.
void AppendBlocks(const GraphIndex& index, int first_column, BlockStructure* structure) {
  const std::size_t first_edge = structure->slot_of_edge.size();
  const Adjacency adjacency = MakeAdjacency(index, structure->column_of_node, first_edge,
                                            first_column, structure->columns());
  const int first_block = structure->blocks();
  structure->row.insert(structure->row.end(), adjacency.row.begin(), adjacency.row.end());
  for (std::size_t k = 1; k < adjacency.begin.size(); ++k) {
    structure->begin.push_back(first_block + adjacency.begin[k]);
  }
  structure->slot_of_edge.resize(index.edges.size());
  for (std::size_t e = first_edge; e < index.edges.size(); ++e) {
    const int i = structure->column_of_node[index.edges[e].i];
    const int j = structure->column_of_node[index.edges[e].j];
    if (i < 0 || j < 0 || i == j) continue;
    const auto first = structure->row.begin() + structure->begin[std::max(i, j)];
    const auto last = structure->row.begin() + structure->begin[std::max(i, j) + 1];
    const auto block = std::lower_bound(first, last, std::min(i, j));
    structure->slot_of_edge[e] = {static_cast<int>(block - structure->row.begin()), j < i};
  }
}

}  // namespace

BlockStructure OrderByMinimumDegree(const GraphIndex& index) {
  std::vector<int> free_node, number_of_node(index.fixed.size(), -1);
  for (int k = 0; k < static_cast<int>(index.fixed.size()); ++k) {
    if (index.fixed[k]) continue;
    number_of_node[k] = static_cast<int>(free_node.size());
    free_node.push_back(k);
  }
  BlockStructure structure;
  const int columns = static_cast<int>(free_node.size());
  structure.node_of_column.resize(columns);
  structure.column_of_node.assign(index.fixed.size(), -1);
  structure.begin = {0};
  const Adjacency adjacency = MakeAdjacency(index, number_of_node, 0, 0, columns);
  if (adjacency.row.empty()) {
    std::iota(structure.node_of_column.begin(), structure.node_of_column.end(), 0);
  } else {
    if (amd_order(columns, adjacency.begin.data(), adjacency.row.data(),
                  structure.node_of_column.data(), nullptr, nullptr) != AMD_OK) {
      throw std::bad_alloc();  // its only other reason would be a malformed matrix
    }
  }
  for (int k = 0; k < columns; ++k) {
    const int node = free_node[structure.node_of_column[k]];
    structure.node_of_column[k] = node;
    structure.column_of_node[node] = k;
  }
  AppendBlocks(index, 0, &structure);
  return structure;
}

bool AppendNewNodes(const GraphIndex& index, BlockStructure* structure) {
  const int first_column = structure->columns();
  for (std::size_t node = structure->column_of_node.size(); node < index.fixed.size(); ++node) {
    structure->column_of_node.push_back(index.fixed[node] ? -1 : structure->columns());
    if (!index.fixed[node]) structure->node_of_column.push_back(static_cast<int>(node));
  }
  for (std::size_t e = structure->slot_of_edge.size(); e < index.edges.size(); ++e) {
    const int i = structure->column_of_node[index.edges[e].i];
    const int j = structure->column_of_node[index.edges[e].j];
    const bool both_free = i >= 0 && j >= 0 && i != j;
    if (both_free && std::max(i, j) < first_column) return false;
  }
  AppendBlocks(index, first_column, structure);
  return true;
}

}  // namespace gmapping_spa::spa
