// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/fronts.h"

#include <algorithm>
#include <utility>

namespace gmapping_spa::spa {
namespace {

// A group of columns while fronts are merged.
struct Group {
  int first = 0;
  int pivots = 0;
  int rows = 0;
  std::int64_t zeros = 0;  // blocks that merging added
};

// Blocks of the dense matrix of a group, without those above the diagonal.
std::int64_t Blocks(std::int64_t pivots, std::int64_t rows) {
  return pivots * (pivots + 1) / 2 + pivots * rows;
}

// The parts of zeros that groups may have, by the number of pivots.
bool AreFewZeros(std::int64_t zeros, std::int64_t blocks, int pivots) {
  if (pivots <= 2) return true;
  const double part = static_cast<double>(zeros) / static_cast<double>(blocks);
  if (pivots <= 6) return part < 0.2;
  if (pivots <= 16) return part < 0.05;
  return part < 0.02;
}

// Groups of columns whose parent is the next column, merged from left to right.
std::vector<Group> FindGroups(const EliminationTree& tree) {
  std::vector<Group> groups;
  for (int k = 0; k < tree.columns(); ++k) {
    Group group{k, 1, tree.count[k], 0};
    // The group before it, as long as it ends with a child of this one.
    while (!groups.empty() && tree.parent[group.first - 1] == group.first) {
      const Group& child = groups.back();
      const int pivots = child.pivots + group.pivots;
      const std::int64_t blocks = Blocks(pivots, group.rows);
      const std::int64_t zeros = child.zeros + group.zeros + blocks -
                                 Blocks(child.pivots, child.rows) -
                                 Blocks(group.pivots, group.rows);
      if (zeros > child.zeros + group.zeros && !AreFewZeros(zeros, blocks, pivots)) break;
      group = {child.first, pivots, group.rows, zeros};
      groups.pop_back();
    }
    groups.push_back(group);
  }
  return groups;
}

// Counting sort of the blocks by the front of their row.
void FindEntries(const BlockStructure& structure, const std::vector<int>& front_of_column,
                 Fronts* fronts) {
  std::vector<int> next(fronts->fronts.size() + 1, 0);
  for (const int row : structure.row) ++next[front_of_column[row] + 1];
  for (std::size_t f = 0; f < fronts->fronts.size(); ++f) {
    fronts->fronts[f].entries = next[f + 1];
    next[f + 1] += next[f];
    fronts->fronts[f].entry_begin = next[f];
  }
  fronts->entry.resize(structure.row.size());
  for (int k = 0; k < structure.columns(); ++k) {
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      fronts->entry[next[front_of_column[structure.row[p]]]++] = {p, k};
    }
  }
}

}  // namespace

Fronts FindFronts(const BlockStructure& structure, const EliminationTree& tree) {
  Fronts result;
  std::vector<int> front_of_column(structure.columns());
  for (const Group& group : FindGroups(tree)) {
    const int number = static_cast<int>(result.fronts.size());
    std::fill_n(front_of_column.begin() + group.first, group.pivots, number);
    Front front;
    front.first = group.first;
    front.pivots = group.pivots;
    result.fronts.push_back(front);
  }
  FindEntries(structure, front_of_column, &result);

  // The rows of a front are those of its entries and of its children, as far as they are below.
  std::vector<int> seen_by(structure.columns(), -1);
  for (int f = 0; f < static_cast<int>(result.fronts.size()); ++f) {
    Front& front = result.fronts[f];
    front.row_begin = static_cast<int>(result.row.size());
    const auto add = [&](int row) {
      if (row < front.first + front.pivots || seen_by[row] == f) return;
      seen_by[row] = f;
      result.row.push_back(row);
    };
    for (int e = 0; e < front.entries; ++e) add(result.entry[front.entry_begin + e].column);
    for (int c = front.first_child; c >= 0; c = result.fronts[c].next_child) {
      const Front& child = result.fronts[c];
      for (int r = 0; r < child.rows; ++r) add(result.row[child.row_begin + r]);
      front.work += child.work;
    }
    std::sort(result.row.begin() + front.row_begin, result.row.end());
    front.rows = static_cast<int>(result.row.size()) - front.row_begin;
    for (int p = 0; p < front.pivots; ++p) {
      const std::int64_t below = front.pivots - 1 - p + front.rows;
      front.work += below * (below + 1) / 2;
    }
    if (front.rows > 0) {
      front.parent = front_of_column[result.row[front.row_begin]];
      front.next_child = std::exchange(result.fronts[front.parent].first_child, f);
    }
  }
  return result;
}

}  // namespace gmapping_spa::spa
