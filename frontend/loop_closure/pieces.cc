// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/pieces.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gmapping_spa::loop_closure {

using backend::Edge;
using backend::SE2;

namespace {

// A piece that its closure finds this far off is put right by optimization.
constexpr double kAboutRight_m = 1.0;
constexpr double kAboutRight_rad = 0.3;

// Farther than any building reaches, near enough for poses to keep their digits.
constexpr double kOutOfSight_m = 1e4;

}  // namespace

void Pieces::Begin(int node, bool wheels_told_way) {
  CHECK_GT(node, first_nodes_.back());
  first_nodes_.push_back(node);
  wheels_told_way_.push_back(wheels_told_way ? 1 : 0);
}

int Pieces::PieceOf(int node) const {
  const auto after = std::upper_bound(first_nodes_.begin(), first_nodes_.end(), node);
  return static_cast<int>(after - first_nodes_.begin()) - 1;
}

bool Pieces::BeginsAt(int node) const {
  return node > 0 && std::binary_search(first_nodes_.begin(), first_nodes_.end(), node);
}

std::vector<int> Pieces::Joined(std::span<const Edge> closures) const {
  std::vector<int> joined(size());
  std::iota(joined.begin(), joined.end(), 0);
  for (const Edge& closure : closures) {
    const auto [to, from] = std::minmax(joined[PieceOf(static_cast<int>(closure.i))],
                                        joined[PieceOf(static_cast<int>(closure.j))]);
    // Copies: `from` refers to what is replaced.
    std::replace(joined.begin(), joined.end(), int{from}, int{to});
  }
  return joined;
}

std::vector<bool> Pieces::JoinedWith(int node, std::span<const Edge> closures) const {
  const std::vector<int> joined = Joined(closures);
  std::vector<bool> with;
  with.reserve(joined.size());
  for (const int earliest : joined) with.push_back(earliest == joined[PieceOf(node)]);
  return with;
}

std::vector<bool> Pieces::Largest(int nodes, std::span<const Edge> closures) const {
  const std::vector<int> joined = Joined(closures);
  std::vector<int> sizes(size(), 0);
  for (int node = 0; node < nodes; ++node) ++sizes[joined[PieceOf(node)]];
  const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  return JoinedWith(first_nodes_[largest], closures);
}

void Pieces::Arrange(std::span<const Edge> closures, std::vector<SE2>* world_T_nodes) const {
  std::vector<bool> is_placed(size(), false);
  for (int first = 0; first < size(); ++first) {
    if (is_placed[first]) continue;
    is_placed[first] = true;
    // From the pieces that are placed, along closures, to all that can be reached.
    for (bool grows = true; grows;) {
      grows = false;
      for (const Edge& closure : closures) {
        const int i = PieceOf(static_cast<int>(closure.i));
        const int j = PieceOf(static_cast<int>(closure.j));
        if (is_placed[i] == is_placed[j]) continue;
        const SE2& world_T_i = (*world_T_nodes)[closure.i];
        const SE2& world_T_j = (*world_T_nodes)[closure.j];
        const SE2 off = Between(Between(world_T_i, world_T_j), closure.i_T_j);
        const bool is_right =
            off.translation().norm() <= kAboutRight_m && std::abs(off.theta) <= kAboutRight_rad;
        if (!is_right && is_placed[i]) {
          Move(j, world_T_i * closure.i_T_j * Inverse(world_T_j), world_T_nodes);
        } else if (!is_right) {
          Move(i, world_T_j * Inverse(closure.i_T_j) * Inverse(world_T_i), world_T_nodes);
        }
        is_placed[i] = is_placed[j] = true;
        grows = true;
      }
    }
  }
}

void Pieces::Arrange(std::span<const Edge> closures, backend::PoseGraph* path) const {
  if (size() == 1) return;
  std::vector<SE2> poses = backend::PosesOf(*path);
  Arrange(closures, &poses);
  for (std::size_t k = 0; k < poses.size(); ++k) path->nodes[k].world_T_node = poses[k];
}

void Pieces::Separate(std::span<const Edge> closures, Sight sight,
                      std::vector<SE2>* world_T_nodes) const {
  std::vector<int> groups = Joined(closures);  // by the earliest piece
  for (int piece = 1; piece < size(); ++piece) {
    if (!IsInSight(piece, sight)) continue;
    const auto [to, from] = std::minmax(groups[piece - 1], groups[piece]);
    std::replace(groups.begin(), groups.end(), int{from}, int{to});
  }
  for (int piece = 0; piece < size(); ++piece) {
    if (groups[piece] > 0) Move(piece, {kOutOfSight_m * groups[piece], 0, 0}, world_T_nodes);
  }
}

void Pieces::Move(int piece, const SE2& to_T_from, std::vector<SE2>* world_T_nodes) const {
  const int end =
      piece + 1 < size() ? first_nodes_[piece + 1] : static_cast<int>(world_T_nodes->size());
  for (int node = first_nodes_[piece]; node < end; ++node) {
    (*world_T_nodes)[node] = to_T_from * (*world_T_nodes)[node];
  }
}

}  // namespace gmapping_spa::loop_closure
