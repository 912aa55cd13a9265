// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/pause_gate.h"

#include <chrono>

namespace gmapping_spa::view {

void PauseGate::Pause() {
  const std::lock_guard lock(mutex_);
  is_paused_ = true;
  steps_ = 0;
}

void PauseGate::Resume() {
  const std::lock_guard lock(mutex_);
  is_paused_ = false;
  changed_.notify_all();
}

void PauseGate::Step() {
  const std::lock_guard lock(mutex_);
  is_paused_ = true;
  ++steps_;
  changed_.notify_all();
}

void PauseGate::Pass(const std::function<bool()>& gives_up) {
  if (!is_paused_) return;
  std::unique_lock lock(mutex_);
  while (is_paused_ && steps_ == 0) {
    lock.unlock();
    if (gives_up()) return;
    lock.lock();
    changed_.wait_for(lock, std::chrono::milliseconds(100),
                      [this] { return !is_paused_ || steps_ > 0; });
  }
  if (steps_ > 0) --steps_;
}

}  // namespace gmapping_spa::view
