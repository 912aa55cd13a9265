// SPDX-License-Identifier: BSD-3-Clause
// What somebody at a page wants: said in one thread, done in another.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_CONTROLS_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_CONTROLS_H_

#include <Eigen/Core>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/drive/slam_variant.h"

namespace gmapping_spa::drive {

struct DriveWishes {
  // How it is now.
  double forward = 0.0;  // -1 to 1, of the highest speed
  double left = 0.0;     // likewise, of the highest turn rate
  bool paused = false;
  double odometry_noise = 1.0;
  double slips_per_m = 0.01;

  // To be done once.
  std::optional<Eigen::Vector2d> goal = std::nullopt;
  bool save = false;
  std::vector<VariantChoice> added = {};
  std::vector<int> removed = {};  // by their runs

  bool holds() const { return forward != 0.0 || left != 0.0; }
};

class DriveControls {
 public:
  using Clock = std::chrono::steady_clock;
  // Keys that nobody says to hold for so long are let go: the page, its machine or the connection
  // hangs. The page says it four times as often.
  static constexpr Clock::duration kHoldPatience = std::chrono::seconds(1);

  explicit DriveControls(DriveWishes wishes) : wishes_(std::move(wishes)) {}

  template <typename Change>
  void Update(const Change& change) {
    const std::lock_guard lock(mutex_);
    change(&wishes_);
  }

  void Hold(double forward, double left, Clock::time_point now = Clock::now()) {
    const std::lock_guard lock(mutex_);
    wishes_.forward = forward;
    wishes_.left = left;
    held_at_ = now;
  }

  // What is to be done once is taken out.
  DriveWishes Take(Clock::time_point now = Clock::now()) {
    const std::lock_guard lock(mutex_);
    if (now - held_at_ > kHoldPatience) wishes_.forward = wishes_.left = 0.0;
    DriveWishes taken = wishes_;
    wishes_.goal.reset();
    wishes_.save = false;
    wishes_.added.clear();
    wishes_.removed.clear();
    return taken;
  }

 private:
  std::mutex mutex_;
  DriveWishes wishes_;
  Clock::time_point held_at_;  // when it was said last what is held
};

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_CONTROLS_H_
