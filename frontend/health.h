// SPDX-License-Identifier: BSD-3-Clause
// What a run noticed that its user should know: bad input, lost and ambiguous stretches.
#ifndef GMAPPING_SPA_FRONTEND_HEALTH_H_
#define GMAPPING_SPA_FRONTEND_HEALTH_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gmapping_spa::frontend {

// All findings of one kind.
struct Finding {
  std::string message;         // of the first of them
  double first_stamp_s = 0.0;  // of the first and the last reported; nan where no time is known
  double last_stamp_s = 0.0;
  std::int64_t count = 0;

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(message, first_stamp_s, last_stamp_s, count);
  }
};

// A stretch of time, both ends included.
struct Stretch {
  double begin_s = 0.0;
  double end_s = 0.0;
  std::int64_t scans = 1;  // that were marked

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(begin_s, end_s, scans);
  }
};

// Collects findings by their kind, a short name such as "odometry_restart" that stands in the run
// record. Says the first of a kind at once, as a warning of one line, and no other: a fault that
// comes with every scan must not bury the rest.
class Health {
 public:
  // Counts a finding. `message` is one line without the time, which the warning adds.
  void Report(const std::string& kind, double stamp_s, const std::string& message);

  // Counts a scan as part of a stretch of that kind ("lost", "ambiguous"). Scans less than 2 s
  // apart belong to one stretch.
  void Mark(const std::string& kind, double stamp_s);

  // Makes one of stretches of that kind that overlap or are less than 2 s apart, in whatever order
  // their scans were marked.
  void MergeStretches(const std::string& kind);

  const std::map<std::string, Finding>& findings() const { return findings_; }
  // In the order in which they were marked, or of time once merged.
  const std::map<std::string, std::vector<Stretch>>& stretches() const { return stretches_; }

  // For the end of a run: a warning of one line for each kind with more than one finding, and for
  // each kind of stretch.
  void LogSummary() const;

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(findings_, stretches_);
  }

 private:
  std::map<std::string, Finding> findings_;
  std::map<std::string, std::vector<Stretch>> stretches_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_HEALTH_H_
