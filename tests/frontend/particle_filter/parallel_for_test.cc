// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <thread>
#include <vector>

namespace gmapping_spa::particle_filter {
namespace {

TEST(ParallelFor, CallsEveryIndexOnceHoweverManyThreads) {
  for (const int threads : {1, 2, 3, 8}) {
    for (const int count : {0, 1, 2, 7, 100, 1000, 3}) {
      std::vector<int> calls(count);  // not atomic: the end of the loop must publish all of it
      ParallelFor(threads, count, [&](int i) { ++calls[i]; });
      for (int i = 0; i < count; ++i) ASSERT_EQ(calls[i], 1) << threads << " threads, index " << i;
    }
  }
}

TEST(ParallelFor, OneThreadIsTheCallingOneAndWorksInOrder) {
  const std::thread::id caller_id = std::this_thread::get_id();
  std::vector<int> order;
  ParallelFor(1, 5, [&](int i) {
    EXPECT_EQ(std::this_thread::get_id(), caller_id);
    order.push_back(i);
  });
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(ParallelFor, ThrowsWhatAnItemThrowsWhenAllThreadsHaveEnded) {
  for (const int threads : {1, 2, 8}) {
    std::atomic<int> calls = 0;
    EXPECT_THROW(ParallelFor(threads, 1000,
                             [&](int i) {
                               ++calls;
                               if (i == 10) throw std::bad_alloc();
                             }),
                 std::bad_alloc);
    EXPECT_GE(calls, 11);
  }
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
