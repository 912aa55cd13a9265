// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/consistent_set.h"

#include <glog/logging.h>

#include <array>
#include <bit>
#include <cstdint>

namespace gmapping_spa::loop_closure {
namespace {

using Bits = std::uint64_t;
constexpr int kMaxSteps = 100000;

class CliqueSearch {
 public:
  CliqueSearch(int count, const std::function<bool(int, int)>& consistent) {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < i; ++j) {
        if (!consistent(i, j)) continue;
        neighbors_[i] |= Bits{1} << j;
        neighbors_[j] |= Bits{1} << i;
      }
    }
  }

  // Extends the clique `taken` by what of `left`, all of which goes together with it, is best.
  void Extend(Bits taken, Bits left) {
    if (std::popcount(taken) > std::popcount(best_)) best_ = taken;
    if (++steps_ > kMaxSteps) return;
    // Vertices of one color are not neighbors: a clique has at most one of each color.
    std::array<int, kMaxConsistentSet> order;
    std::array<int, kMaxConsistentSet> colors;
    int colored = 0, color = 0;
    for (Bits uncolored = left; uncolored != 0;) {
      ++color;
      for (Bits free = uncolored; free != 0;) {
        const int vertex = std::countr_zero(free);
        free &= ~(neighbors_[vertex] | Bits{1} << vertex);
        uncolored &= ~(Bits{1} << vertex);
        order[colored] = vertex;
        colors[colored++] = color;
      }
    }
    while (colored-- > 0) {
      if (std::popcount(taken) + colors[colored] <= std::popcount(best_)) return;
      const int vertex = order[colored];
      Extend(taken | Bits{1} << vertex, left & neighbors_[vertex]);
      left &= ~(Bits{1} << vertex);
    }
  }

  Bits best() const { return best_; }

 private:
  std::array<Bits, kMaxConsistentSet> neighbors_{};
  Bits best_ = 0;
  int steps_ = 0;
};

}  // namespace

std::vector<int> LargestConsistentSet(int count, const std::function<bool(int, int)>& consistent) {
  CHECK_GE(count, 0);
  CHECK_LE(count, kMaxConsistentSet);
  CliqueSearch search(count, consistent);
  search.Extend(0, count == kMaxConsistentSet ? ~Bits{0} : (Bits{1} << count) - 1);
  std::vector<int> set;
  for (int i = 0; i < count; ++i) {
    if (search.best() >> i & 1) set.push_back(i);
  }
  return set;
}

}  // namespace gmapping_spa::loop_closure
