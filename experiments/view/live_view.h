// SPDX-License-Identifier: BSD-3-Clause
// A run of SLAM to look at while it goes.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_LIVE_VIEW_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_LIVE_VIEW_H_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "experiments/view/figure_history.h"
#include "experiments/view/pause_gate.h"
#include "experiments/view/slam_observer.h"
#include "experiments/view/snapshot.h"
#include "experiments/view/view_hub.h"
#include "experiments/view/view_server.h"

namespace gmapping_spa::view {

// Costs the run next to nothing as long as nobody looks, and then up to ten snapshots a second. It
// changes nothing of the results.
class LiveView : public SlamObserver {
 public:
  // `is_asked_to_stop`: whether the user wants the program to end, in spite of a pause. Throws as
  // ViewServer does.
  LiveView(const ServerOptions& options, const RunTitle& title,
           std::function<bool()> is_asked_to_stop);

  std::uint16_t port() const { return server_.port(); }

  // Returns when somebody looks.
  void WaitForClient();
  // Serves what was shown last, until the user wants the program to end.
  void Keep();
  // Before the end: sees that everybody gets what was sent.
  void Drain();

  // Also holds the run while it is paused; a pause ends ten seconds after the last client has gone.
  void AfterScan(const frontend::ImprovedGmapping& gmapping, const sensor::LaserScan& scan,
                 const ScanResult& result) override;
  void BeforeFinish() override;
  void AfterFinish(const frontend::ImprovedGmapping& gmapping,
                   const frontend::SlamResult& result) override;

 private:
  using Clock = std::chrono::steady_clock;

  void MeasureSpeed();
  bool SnapshotIsDue(bool is_paused);
  void Publish(Snapshot snapshot);
  void HoldWhilePaused();

  std::function<bool()> is_asked_to_stop_;
  PauseGate gate_;
  FigureHistory history_;
  ViewHub hub_;
  ViewServer server_;  // ends before what its conversations use

  std::atomic<bool> is_on_its_way_ = false;  // a snapshot
  Clock::time_point published_;
  Clock::time_point speed_since_;
  std::int64_t scans_since_ = 0;
  double scans_per_s_;
  std::vector<Figures> unpublished_;  // what was added to the history since, if somebody looks
  std::int64_t published_updates_ = 0, published_corrections_ = 0;  // of the graph
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_LIVE_VIEW_H_
