// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/slam_variant.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "experiments/simulation/scan_player.h"
#include "experiments/view/slam_snapshot.h"
#include "frontend/slam_parts.h"

namespace gmapping_spa::drive {
namespace {

constexpr auto kLook = std::chrono::milliseconds(50);  // for what was asked for
constexpr auto kScorePeriod = std::chrono::seconds(2);
constexpr std::size_t kFarBehind = 50;  // scans

}  // namespace

SlamVariant::SlamVariant(VariantSetup setup, const RecordedTour* tour, const map::TrinaryMap* truth,
                         double max_range_m, VariantListener listener)
    : setup_(std::move(setup)),
      tour_(tour),
      truth_(truth),
      max_range_m_(max_range_m),
      listener_(std::move(listener)) {
  thread_ = std::thread([this] { Run(); });
}

SlamVariant::~SlamVariant() {
  stops_ = true;
  thread_.join();
}

std::shared_ptr<const VariantResult> SlamVariant::Finish(
    const std::function<bool()>& is_asked_to_stop) {
  std::unique_lock lock(mutex_);
  if (tour_->steps() == 0 || has_failed_) return nullptr;
  finish_wanted_ = true;
  while (finish_wanted_ && !is_asked_to_stop()) is_finished_.wait_for(lock, kLook);
  return finish_wanted_ || has_failed_ ? nullptr : result_;
}

void SlamVariant::Run() {
  try {
    Begin();
    while (!stops_) Work();
  } catch (const std::exception& error) {
    Tell(std::string("failed: ") + error.what());
  }
  const std::lock_guard lock(mutex_);
  has_failed_ = true;
  finish_wanted_ = false;
  is_finished_.notify_all();
}

void SlamVariant::Begin() {
  gmapping_ = std::make_unique<frontend::ImprovedGmapping>(
      frontend::GmappingOptions(setup_.options), frontend::MakeScanMatcher(setup_.options),
      frontend::BindOptimizer(setup_.options, setup_.load_optimizer()));
  gmapping_->StopWaitingWhen([this] { return stops_.load(); });
  scorer_ = std::make_unique<MapScorer>(truth_, tour_, max_range_m_);
  steps_ = 0;
  taken_ = shown_scans_ = scored_scans_ = 0;
}

void SlamVariant::Work() {
  if (tour_->WaitForMore(steps_, kLook)) {
    if (gmapping_ == nullptr) Begin();
    Tell(tour_->steps() - steps_ > kFarBehind ? "replaying" : "following");
    TakeStep();
    ShowLatest();
    if (std::chrono::steady_clock::now() > next_score_) ScoreLatest();
    return;
  }
  bool wanted = false;
  {
    const std::lock_guard lock(mutex_);
    wanted = finish_wanted_;
  }
  if (wanted) return MakeResult();
  ShowLatest();
  ScoreLatest();
}

void SlamVariant::TakeStep() {
  simulation::ScanPlayer player([&](const sensor::LaserScan& scan) {
    latest_scan_ = scan;
    latest_scan_.index = taken_++;
    latest_ = gmapping_->AddScan(latest_scan_);
  });
  tour_->Play(steps_, steps_ + 1, &player);
  ++steps_;
}

void SlamVariant::ShowLatest() {
  if (gmapping_ == nullptr || shown_scans_ == taken_ || !listener_.wants_snapshot()) return;
  view::Snapshot snapshot = view::SnapshotOf(*gmapping_, latest_scan_, latest_);
  snapshot.graph = view::GraphOf(*gmapping_);
  snapshot.history = {snapshot.figures};
  listener_.on_snapshot(std::move(snapshot));
  shown_scans_ = taken_;
}

void SlamVariant::ScoreLatest() {
  if (gmapping_ == nullptr || scored_scans_ == taken_) return;
  const auto begin = std::chrono::steady_clock::now();
  listener_.on_score(scorer_->Score(gmapping_->CurrentTrajectory(), gmapping_->CurrentMap(),
                                    setup_.options.occupied_threshold));
  scored_scans_ = taken_;
  const auto end = std::chrono::steady_clock::now();
  // Most of the time is for SLAM, however long the tour is.
  next_score_ =
      end + std::max<std::chrono::steady_clock::duration>(kScorePeriod, 4 * (end - begin));
}

void SlamVariant::MakeResult() {
  if (gmapping_ != nullptr && taken_ > 0) {
    Tell("finishing");
    frontend::SlamResult estimate = gmapping_->Finish();
    listener_.on_snapshot(view::SnapshotOf(*gmapping_, estimate));
    const MapScore score =
        scorer_->Score(estimate.trajectory, estimate.map, setup_.options.occupied_threshold);
    listener_.on_score(score);
    // What comes later begins anew: the final optimization is not a part of what SLAM would do.
    gmapping_.reset();
    Tell("finished");
    const std::lock_guard lock(mutex_);
    result_ = std::make_shared<VariantResult>(VariantResult{std::move(estimate), score});
  }
  const std::lock_guard lock(mutex_);
  finish_wanted_ = false;
  is_finished_.notify_all();
}

void SlamVariant::Tell(const std::string& state) {
  if (state == told_) return;
  told_ = state;
  listener_.on_state(state);
}

}  // namespace gmapping_spa::drive
