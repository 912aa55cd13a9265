// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/progress_bar.h"

#include <unistd.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>

namespace gmapping_spa::apps {
namespace {

// 75 s is "1:15", 3600 s is "1:00:00".
std::string FormatDuration(double duration_s) {
  const auto seconds = static_cast<std::int64_t>(std::llround(duration_s));
  const std::int64_t hours = seconds / 3600;
  std::ostringstream out;
  out << std::setfill('0');
  if (hours > 0) out << hours << ':' << std::setw(2);
  out << seconds / 60 % 60 << ':' << std::setw(2) << seconds % 60;
  return out.str();
}

}  // namespace

ProgressBar::ProgressBar(std::string label, std::int64_t total, std::chrono::milliseconds interval)
    : label_(std::move(label)),
      total_(total),
      enabled_(isatty(STDERR_FILENO) == 1),
      interval_(interval) {}

ProgressBar::~ProgressBar() {
  if (!enabled_ || done_ == 0) return;
  Show(Clock::now());
  std::cerr << '\n';
}

void ProgressBar::Update(std::int64_t done) {
  done_ = done;
  if (!enabled_) return;
  const Clock::time_point now = Clock::now();
  if (now - last_shown_ >= interval_) Show(now);
}

void ProgressBar::Show(Clock::time_point now) {
  const std::string text =
      FormatProgress(label_, done_, total_, std::chrono::duration<double>(now - start_).count());
  // Blanks cover the rest of a longer line before.
  const std::size_t rest = shown_length_ > text.size() ? shown_length_ - text.size() : 0;
  std::cerr << '\r' << text << std::string(rest, ' ') << std::flush;
  shown_length_ = text.size();
  last_shown_ = now;
}

std::string FormatProgress(const std::string& label, std::int64_t done, std::int64_t total,
                           double elapsed_s) {
  std::ostringstream out;
  out << label << ": ";
  if (total <= 0) {
    out << done << " [" << FormatDuration(elapsed_s) << " elapsed]";
    return out.str();
  }
  out << std::setw(3) << 100 * done / total << "% " << done << '/' << total << " ["
      << FormatDuration(elapsed_s) << " elapsed";
  if (done > 0 && done < total) {
    const double left_s = elapsed_s / static_cast<double>(done) * static_cast<double>(total - done);
    out << ", " << FormatDuration(left_s) << " left";
  }
  out << ']';
  return out.str();
}

}  // namespace gmapping_spa::apps
