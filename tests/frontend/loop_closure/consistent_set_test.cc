// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/consistent_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>

namespace gmapping_spa::loop_closure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(LargestConsistentSet, OfNothingIsEmpty) {
  EXPECT_THAT(LargestConsistentSet(0, [](int, int) { return true; }), IsEmpty());
}

TEST(LargestConsistentSet, IsASingleOneWhereNothingGoesTogether) {
  EXPECT_THAT(LargestConsistentSet(5, [](int, int) { return false; }), SizeIs(1));
}

TEST(LargestConsistentSet, IsEverythingWhereAllGoTogether) {
  EXPECT_THAT(LargestConsistentSet(kMaxConsistentSet, [](int, int) { return true; }),
              SizeIs(kMaxConsistentSet));
}

TEST(LargestConsistentSet, LeavesOutTheSmallerParty) {
  const auto party = [](int k) { return k == 1 || k == 4; };
  EXPECT_THAT(LargestConsistentSet(6, [&](int a, int b) { return party(a) == party(b); }),
              ElementsAre(0, 2, 3, 5));
}

TEST(LargestConsistentSet, IsAsLargeAsTheBestOfAllSubsets) {
  std::mt19937 random(1);
  for (int round = 0; round < 30; ++round) {
    constexpr int kCount = 12;
    std::uint32_t neighbors[kCount] = {};
    for (int i = 0; i < kCount; ++i) {
      for (int j = 0; j < i; ++j) {
        if (random() % 10 < 6) neighbors[i] |= 1u << j, neighbors[j] |= 1u << i;
      }
    }
    int largest = 0;
    for (std::uint32_t set = 0; set < 1u << kCount; ++set) {
      bool together = true;
      for (int i = 0; i < kCount && together; ++i) {
        if (set >> i & 1) together = (set & ~neighbors[i]) == 1u << i;
      }
      if (together) largest = std::max(largest, std::popcount(set));
    }
    const std::vector<int> found =
        LargestConsistentSet(kCount, [&](int a, int b) { return (neighbors[a] >> b & 1) != 0; });
    EXPECT_THAT(found, SizeIs(largest));
    for (const int a : found) {
      for (const int b : found) EXPECT_TRUE(a == b || (neighbors[a] >> b & 1) != 0);
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
