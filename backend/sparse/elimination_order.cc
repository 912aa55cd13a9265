// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/elimination_order.h"

#include <metis.h>
#include <suitesparse/amd.h>

#include <algorithm>
#include <new>
#include <numeric>

namespace gmapping_spa::spa {
namespace {

using Neighbors = std::vector<std::vector<int>>;  // of each column

Neighbors NeighborsOf(const Adjacency& adjacency) {
  Neighbors neighbors(adjacency.columns());
  for (int k = 0; k < adjacency.columns(); ++k) {
    for (int p = adjacency.begin[k]; p < adjacency.begin[k + 1]; ++p) {
      neighbors[k].push_back(adjacency.row[p]);
      neighbors[adjacency.row[p]].push_back(k);
    }
  }
  return neighbors;
}

// Eliminates columns of two neighbors at most while there are any, which connects the two: no
// other order has less fill there. Returns them; those that stay keep their neighbors.
std::vector<int> EliminateStretches(Neighbors* neighbors) {
  std::vector<int> order;
  std::vector<bool> is_eliminated(neighbors->size(), false);
  const auto has_few = [&](int column) { return (*neighbors)[column].size() <= 2; };
  std::vector<int> candidates;
  for (int k = static_cast<int>(neighbors->size()) - 1; k >= 0; --k) {
    if (has_few(k)) candidates.push_back(k);
  }
  while (!candidates.empty()) {
    const int column = candidates.back();
    candidates.pop_back();
    if (is_eliminated[column]) continue;
    is_eliminated[column] = true;
    order.push_back(column);
    const std::vector<int> around = std::move((*neighbors)[column]);
    for (const int other : around) std::erase((*neighbors)[other], column);
    if (around.size() == 2) {
      std::vector<int>&a = (*neighbors)[around[0]], &b = (*neighbors)[around[1]];
      if (std::ranges::find(a, around[1]) == a.end()) {
        a.push_back(around[1]);
        b.push_back(around[0]);
      }
    }
    for (const int other : around) {
      if (has_few(other)) candidates.push_back(other);
    }
  }
  return order;
}

// The order of METIS for those columns, which are connected among each other only.
std::vector<int> Dissect(const Neighbors& neighbors, const std::vector<int>& columns) {
  std::vector<idx_t> number(neighbors.size());
  for (std::size_t k = 0; k < columns.size(); ++k) number[columns[k]] = static_cast<idx_t>(k);
  std::vector<idx_t> begin = {0}, neighbor;
  for (const int column : columns) {
    for (const int other : neighbors[column]) neighbor.push_back(number[other]);
    begin.push_back(static_cast<idx_t>(neighbor.size()));
  }
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_COMPRESS] = 0;  // poses hardly ever have the same neighbors
  auto count = static_cast<idx_t>(columns.size());
  std::vector<idx_t> order(count), position(count);
  if (METIS_NodeND(&count, begin.data(), neighbor.data(), nullptr, options, order.data(),
                   position.data()) != METIS_OK) {
    throw std::bad_alloc();  // its only other reason would be a malformed graph
  }
  std::vector<int> ordered(count);
  for (idx_t k = 0; k < count; ++k) ordered[k] = columns[order[k]];
  return ordered;
}

}  // namespace

std::vector<int> MinimumDegreeOrder(const Adjacency& adjacency) {
  std::vector<int> order(adjacency.columns());
  std::iota(order.begin(), order.end(), 0);
  if (!adjacency.row.empty() &&
      amd_order(adjacency.columns(), adjacency.begin.data(), adjacency.row.data(), order.data(),
                nullptr, nullptr) != AMD_OK) {
    throw std::bad_alloc();  // likewise
  }
  return order;
}

std::vector<int> NestedDissectionOrder(const Adjacency& adjacency) {
  Neighbors neighbors = NeighborsOf(adjacency);
  std::vector<int> order = EliminateStretches(&neighbors);
  std::vector<bool> is_ordered(neighbors.size(), false);
  for (const int column : order) is_ordered[column] = true;
  std::vector<int> rest;
  for (int k = 0; k < adjacency.columns(); ++k) {
    if (!is_ordered[k]) rest.push_back(k);
  }
  if (rest.empty()) return order;
  const std::vector<int> dissected = Dissect(neighbors, rest);
  order.insert(order.end(), dissected.begin(), dissected.end());
  return order;
}

}  // namespace gmapping_spa::spa
