// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/health.h"

#include <glog/logging.h>

#include <algorithm>
#include <utility>

#include "backend/text.h"

namespace gmapping_spa::frontend {
namespace {

constexpr double kMaxGapWithinStretchS = 2.0;

std::string Seconds(double time_s) { return backend::FixedText(time_s, 3) + " s"; }

}  // namespace

void Health::Report(const std::string& kind, double stamp_s, const std::string& message) {
  const auto [it, is_new] = findings_.try_emplace(kind, Finding{message, stamp_s, stamp_s, 0});
  if (is_new) LOG(WARNING) << "at " << Seconds(stamp_s) << ": " << message;
  ++it->second.count;
  it->second.last_stamp_s = stamp_s;
}

void Health::Mark(const std::string& kind, double stamp_s) {
  std::vector<Stretch>& stretches = stretches_[kind];
  // A clock that was set back starts another stretch, too.
  if (stretches.empty() || stamp_s >= stretches.back().end_s + kMaxGapWithinStretchS ||
      stamp_s <= stretches.back().begin_s - kMaxGapWithinStretchS) {
    stretches.push_back({.begin_s = stamp_s, .end_s = stamp_s});
    return;
  }
  Stretch& last = stretches.back();
  last.begin_s = std::min(last.begin_s, stamp_s);
  last.end_s = std::max(last.end_s, stamp_s);
  ++last.scans;
}

void Health::MergeStretches(const std::string& kind) {
  const auto found = stretches_.find(kind);
  if (found == stretches_.end()) return;
  std::vector<Stretch> marked = std::move(found->second);
  std::stable_sort(marked.begin(), marked.end(),
                   [](const Stretch& a, const Stretch& b) { return a.begin_s < b.begin_s; });
  std::vector<Stretch> merged;
  for (const Stretch& stretch : marked) {
    if (merged.empty() || stretch.begin_s >= merged.back().end_s + kMaxGapWithinStretchS) {
      merged.push_back(stretch);
      continue;
    }
    merged.back().end_s = std::max(merged.back().end_s, stretch.end_s);
    merged.back().scans += stretch.scans;
  }
  found->second = std::move(merged);
}

void Health::LogSummary() const {
  for (const auto& [kind, finding] : findings_) {
    if (finding.count < 2) continue;
    LOG(WARNING) << kind << ": " << finding.count << " times from "
                 << Seconds(finding.first_stamp_s) << " to " << Seconds(finding.last_stamp_s)
                 << "; the first: " << finding.message;
  }
  for (const auto& [kind, stretches] : stretches_) {
    double total_s = 0.0;
    std::int64_t scans = 0;
    for (const Stretch& stretch : stretches) {
      total_s += stretch.end_s - stretch.begin_s;
      scans += stretch.scans;
    }
    LOG(WARNING) << kind << ": " << stretches.size()
                 << (stretches.size() == 1 ? " stretch" : " stretches") << " of " << scans
                 << (scans == 1 ? " scan and " : " scans and ") << Seconds(total_s)
                 << " in all; the first from " << Seconds(stretches.front().begin_s) << " to "
                 << Seconds(stretches.front().end_s);
  }
}

}  // namespace gmapping_spa::frontend
