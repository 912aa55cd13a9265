// SPDX-License-Identifier: BSD-3-Clause
// Work that does not look whether the user wants the program to end.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_INTERRUPTIBLE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_INTERRUPTIBLE_H_

#include <chrono>
#include <functional>
#include <future>
#include <string>
#include <thread>
#include <utility>

#include "experiments/apps/app.h"

namespace gmapping_spa::apps {

// Calls `work` in a thread of its own and returns, or throws, what it does. Within two seconds
// after a signal it throws Interrupted with `message` and leaves the thread to itself: `work` owns
// all that it uses.
template <typename Result>
Result RunInterruptibly(std::function<Result()> work, const std::string& message) {
  constexpr auto kPatience = std::chrono::seconds(2);
  std::packaged_task<Result()> task(std::move(work));
  std::future<Result> result = task.get_future();
  std::thread thread(std::move(task));  // for want of memory, throws std::system_error
  while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
    if (ReceivedSignal() == 0 || result.wait_for(kPatience) == std::future_status::ready) continue;
    thread.detach();
    throw Interrupted(message);
  }
  thread.join();
  return result.get();
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_INTERRUPTIBLE_H_
