// SPDX-License-Identifier: BSD-3-Clause
// run.json: what was run on what, and what came of it.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_RUN_RECORD_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_RUN_RECORD_H_

#include <chrono>

#include "experiments/apps/json.h"
#include "frontend/improved_gmapping.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::apps {

// Wall-clock times of the stages of a run.
class Stopwatch {
 public:
  // Ends the stage that began with the construction or the last lap.
  void Lap(const char* name) {
    const Clock::time_point now = Clock::now();
    laps_[name] = std::chrono::duration<double>(now - start_).count();
    start_ = now;
  }
  const Json& laps() const { return laps_; }
  // Of the stage so far.
  double elapsed_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  // Counts time that another process spent on the stage.
  void Add(double elapsed_s) {
    start_ -= std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(elapsed_s));
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  Json laps_;
};

// `input` says what the scans came from, `health` what was noticed (HealthRecord). Everything that
// may differ between two runs with the same input, flags and seed (times, memory, and what does not
// change results: --threads and where outputs go) stands under "resources".
Json MakeRunRecord(const Json& input, const frontend::ImprovedGmapping& gmapping,
                   const map::TrinaryMap& map, const Json& health, const Stopwatch& stopwatch);

// What came of going on in the map of another run; `scans` of the log and poses told of them.
Json MapSessionRecord(const frontend::MapSession& session, std::int64_t scans, std::size_t poses);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_RUN_RECORD_H_
