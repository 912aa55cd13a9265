// SPDX-License-Identifier: BSD-3-Clause
// Progress of long work, for people.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_PROGRESS_BAR_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_PROGRESS_BAR_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace gmapping_spa::apps {

// Shows one line on stderr that is rewritten a few times a second; shows nothing when stderr is not
// a terminal.
class ProgressBar {
 public:
  // `total` is the number of items of the work, 0 when it is not known.
  // Shows progress when `interval` has passed since it did so last.
  ProgressBar(std::string label, std::int64_t total,
              std::chrono::milliseconds interval = std::chrono::milliseconds(200));
  // Leaves the last state on a line of its own.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // `done` items are finished.
  void Update(std::int64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  void Show(Clock::time_point now);

  std::string label_;
  std::int64_t total_;
  std::int64_t done_ = 0;
  bool enabled_;
  std::chrono::milliseconds interval_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_ = start_;
  std::size_t shown_length_ = 0;
};

// The text shown: "slam:  25% 1000/4000 [0:10 elapsed, 0:30 left]".
std::string FormatProgress(const std::string& label, std::int64_t done, std::int64_t total,
                           double elapsed_s);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_PROGRESS_BAR_H_
