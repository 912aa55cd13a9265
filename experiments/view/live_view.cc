// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/live_view.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#include "experiments/view/page_files.h"
#include "experiments/view/slam_snapshot.h"

namespace gmapping_spa::view {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(100);  // of snapshots
constexpr auto kSpeedWindow = std::chrono::milliseconds(500);
constexpr auto kPauseWithoutClients = std::chrono::seconds(10);
constexpr auto kDrainPatience = std::chrono::seconds(5);

}  // namespace

LiveView::LiveView(const ServerOptions& options, const RunTitle& title,
                   std::function<bool()> is_asked_to_stop)
    : is_asked_to_stop_(std::move(is_asked_to_stop)),
      history_(kHistoryRows),
      hub_({{title, &history_}}, &gate_),
      server_(options, PageFiles(), hub_.Protocols()),
      speed_since_(Clock::now()),
      scans_per_s_(std::numeric_limits<double>::quiet_NaN()) {}

void LiveView::WaitForClient() {
  while (server_.CountClients() == 0 && !is_asked_to_stop_()) std::this_thread::sleep_for(kPeriod);
  speed_since_ = Clock::now();
}

void LiveView::Keep() {
  while (!is_asked_to_stop_()) std::this_thread::sleep_for(kPeriod);
}

void LiveView::Drain() { server_.Drain(kDrainPatience); }

void LiveView::MeasureSpeed() {
  ++scans_since_;
  const Clock::time_point now = Clock::now();
  if (now - speed_since_ < kSpeedWindow) return;
  const std::chrono::duration<double> time = now - speed_since_;
  scans_per_s_ = static_cast<double>(scans_since_) / time.count();
  scans_since_ = 0;
  speed_since_ = now;
}

bool LiveView::SnapshotIsDue(bool is_paused) {
  if (server_.CountClients() == 0) return false;
  if (!is_paused) return !is_on_its_way_ && Clock::now() - published_ >= kPeriod;
  while (is_on_its_way_) std::this_thread::sleep_for(kPeriod / 100);
  return true;  // who steps wants to see each scan
}

void LiveView::AfterScan(const frontend::ImprovedGmapping& gmapping, const sensor::LaserScan& scan,
                         const ScanResult& result) {
  // Once: a pause that begins while this runs holds at the next scan, after its snapshot.
  const bool is_paused = gate_.is_paused();
  MeasureSpeed();
  if (result.updated) {
    Figures figures = FiguresOf(gmapping, scan.stamp_s, result.world_T_robot);
    figures.scans_per_s = scans_per_s_;
    history_.Add(figures);
    unpublished_.push_back(figures);
  }
  // A new client gets the history as a whole.
  if (server_.CountClients() == 0) unpublished_.clear();
  if (SnapshotIsDue(is_paused)) {
    Snapshot snapshot = SnapshotOf(gmapping, scan, result);
    snapshot.history = std::exchange(unpublished_, {});
    const auto& counts = gmapping.counts();
    if (counts.updates != published_updates_ || counts.corrections != published_corrections_) {
      snapshot.graph = GraphOf(gmapping);
      published_updates_ = counts.updates;
      published_corrections_ = counts.corrections;
    }
    Publish(std::move(snapshot));
  }
  if (is_paused) HoldWhilePaused();
}

void LiveView::Publish(Snapshot snapshot) {
  snapshot.figures.scans_per_s = scans_per_s_;
  is_on_its_way_ = true;
  published_ = Clock::now();
  server_.Post([this, shared = std::make_shared<Snapshot>(std::move(snapshot))] {
    hub_.Apply(0, std::move(*shared));
    is_on_its_way_ = false;
  });
}

void LiveView::HoldWhilePaused() {
  Clock::time_point seen = Clock::now();
  gate_.Pass([&] {
    const Clock::time_point now = Clock::now();
    if (server_.CountClients() > 0) seen = now;
    if (now - seen > kPauseWithoutClients) gate_.Resume();
    return is_asked_to_stop_();
  });
  scans_since_ = 0;  // a pause is not slow
  speed_since_ = Clock::now();
}

void LiveView::BeforeFinish() {
  server_.Post([this] {
    if (hub_.first_run().revisions().frame == 0) return;  // nobody has looked yet
    Snapshot finishing = hub_.first_run().latest();
    finishing.phase = Phase::kFinishing;
    hub_.Apply(0, std::move(finishing));
  });
}

void LiveView::AfterFinish(const frontend::ImprovedGmapping& gmapping,
                           const frontend::SlamResult& result) {
  Publish(SnapshotOf(gmapping, result));
}

}  // namespace gmapping_spa::view
