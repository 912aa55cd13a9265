// SPDX-License-Identifier: BSD-3-Clause
// Holds a run between two scans as long as somebody who looks wants it.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_PAUSE_GATE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_PAUSE_GATE_H_

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace gmapping_spa::view {

// Threads: one passes, others steer.
class PauseGate {
 public:
  void Pause();
  void Resume();
  // Lets one scan through, and pauses.
  void Step();

  bool is_paused() const { return is_paused_; }

  // Returns at once where nobody paused; else when it goes on, or `gives_up` returns true, which is
  // asked every tenth of a second.
  void Pass(const std::function<bool()>& gives_up);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> is_paused_ = false;
  int steps_ = 0;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_PAUSE_GATE_H_
