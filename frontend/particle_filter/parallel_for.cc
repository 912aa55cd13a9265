// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/parallel_for.h"

#include <glog/logging.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace gmapping_spa::particle_filter {

void ParallelFor(int threads, int count, const std::function<void(int)>& work) {
  CHECK_GE(threads, 1);
  std::atomic<int> next = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto take_items = [&] {
    try {
      for (int i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    others.reserve(threads);
    try {
      for (int i = 1; i < std::min(threads, count); ++i) others.emplace_back(take_items);
    } catch (const std::system_error&) {
      // No more threads are to be had: those that there are do all.
    }
    take_items();
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace gmapping_spa::particle_filter
