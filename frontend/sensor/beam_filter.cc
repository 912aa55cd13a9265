// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/beam_filter.h"

#include <utility>

namespace gmapping_spa::sensor {
namespace {

constexpr std::size_t kScansAtATime = 200;

}  // namespace

BeamFilterReader::BeamFilterReader(std::unique_ptr<RecordReader> source,
                                   std::vector<std::unique_ptr<BeamFilter>> filters)
    : source_(std::move(source)), filters_(std::move(filters)), num_changed_(filters_.size(), 0) {}

void BeamFilterReader::Fill() {
  std::vector<const LaserScan*> scans;
  while (scans.size() < kScansAtATime) {
    std::optional<LogRecord> record = source_->Next();
    if (!record) break;
    // References to elements of a deque outlive push_back.
    held_.push_back(std::move(*record));
    if (const auto* scan = std::get_if<ScanRecord>(&held_.back())) scans.push_back(&scan->scan);
  }
  if (scans.empty()) return;
  for (const std::unique_ptr<BeamFilter>& filter : filters_) filter->Learn(scans);
}

std::optional<LogRecord> BeamFilterReader::Next() {
  if (held_.empty()) Fill();
  if (held_.empty()) return std::nullopt;
  LogRecord record = std::move(held_.front());
  held_.pop_front();
  if (auto* scan = std::get_if<ScanRecord>(&record)) {
    for (std::size_t k = 0; k < filters_.size(); ++k) {
      num_changed_[k] += filters_[k]->Apply(&scan->scan);
    }
  }
  return record;
}

LogCounts BeamFilterReader::counts() const {
  LogCounts counts = source_->counts();
  for (std::size_t k = 0; k < filters_.size(); ++k) {
    counts[filters_[k]->count_name()] = num_changed_[k];
  }
  return counts;
}

}  // namespace gmapping_spa::sensor
