// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/adjacency.h"

#include <algorithm>

namespace gmapping_spa::spa {

Adjacency MakeAdjacency(const backend::GraphIndex& index, const std::vector<int>& column_of_node,
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

}  // namespace gmapping_spa::spa
