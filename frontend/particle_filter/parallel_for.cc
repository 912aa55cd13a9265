// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/parallel_for.h"

#include <glog/logging.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace gmapping_spa::particle_filter {

void ParallelFor(int threads, int count, const std::function<void(int)>& work) {
  CHECK_GE(threads, 1);
  std::atomic<int> next = 0;
  const auto take_items = [&] {
    for (int i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < std::min(threads, count); ++i) others.emplace_back(take_items);
  take_items();
}

}  // namespace gmapping_spa::particle_filter
