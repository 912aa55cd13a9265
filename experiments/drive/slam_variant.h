// SPDX-License-Identifier: BSD-3-Clause
// SLAM on the tour, in a thread of its own: all scans so far, and then those that come.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_SLAM_VARIANT_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_SLAM_VARIANT_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "backend/plugin/optimizer.h"
#include "experiments/drive/map_scorer.h"
#include "experiments/drive/recorded_tour.h"
#include "experiments/view/snapshot.h"
#include "frontend/api/scan_result.h"
#include "frontend/api/slam_options.h"
#include "frontend/improved_gmapping.h"
#include "frontend/map/trinary_map.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/slam_result.h"

namespace gmapping_spa::drive {

// What is compared.
struct VariantChoice {
  std::string backend;
  int particles = 5;
  SlamOptions::Correction correction = SlamOptions::Correction::kTrajectory;

  friend bool operator==(const VariantChoice&, const VariantChoice&) = default;
};

struct VariantSetup {
  VariantChoice choice;
  SlamOptions options;
  // In any thread; a new one each time, so that nothing is left over from a run before.
  std::function<std::shared_ptr<backend::Optimizer>()> load_optimizer;
};

struct VariantResult {
  frontend::SlamResult result;
  MapScore score;
};

// Called in the thread of a variant. `state` tells what it does: "replaying", "following",
// "finishing", "finished", or "failed: " and why.
struct VariantListener {
  // Whether a snapshot is wanted now.
  std::function<bool()> wants_snapshot;
  std::function<void(view::Snapshot)> on_snapshot;
  std::function<void(const MapScore&)> on_score;
  std::function<void(const std::string& state)> on_state;
};

class SlamVariant {
 public:
  // Tour and truth, with what could be seen up to a range, outlive this.
  SlamVariant(VariantSetup setup, const RecordedTour* tour, const map::TrinaryMap* truth,
              double max_range_m, VariantListener listener);
  // Stops at the next scan.
  ~SlamVariant();
  SlamVariant(const SlamVariant&) = delete;
  SlamVariant& operator=(const SlamVariant&) = delete;

  const VariantSetup& setup() const { return setup_; }

  // Takes all scans that there are and makes the final optimization: the same as a run of SLAM on
  // the log of the tour so far. Scans that come later begin it anew, from the first scan on. Waits
  // for it as long as `is_asked_to_stop` is false; null then, where it has failed, and without a
  // scan.
  std::shared_ptr<const VariantResult> Finish(const std::function<bool()>& is_asked_to_stop);

 private:
  void Run();
  void Work();
  void Begin();
  void TakeStep();
  void ShowLatest();
  void ScoreLatest();
  void MakeResult();
  void Tell(const std::string& state);

  VariantSetup setup_;
  const RecordedTour* tour_;
  const map::TrinaryMap* truth_;
  double max_range_m_;
  VariantListener listener_;

  // Of the thread.
  std::unique_ptr<frontend::ImprovedGmapping> gmapping_;
  std::unique_ptr<MapScorer> scorer_;
  std::size_t steps_ = 0;          // of the tour
  std::int64_t taken_ = 0;         // scans
  std::int64_t shown_scans_ = 0;   // taken when they were shown last
  std::int64_t scored_scans_ = 0;  // likewise
  sensor::LaserScan latest_scan_;
  ScanResult latest_;
  std::chrono::steady_clock::time_point next_score_;
  std::string told_;

  std::atomic<bool> stops_ = false;
  std::mutex mutex_;
  std::condition_variable is_finished_;
  bool finish_wanted_ = false;
  bool has_failed_ = false;
  std::shared_ptr<const VariantResult> result_;
  std::thread thread_;
};

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_SLAM_VARIANT_H_
