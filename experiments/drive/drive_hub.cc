// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/drive_hub.h"

#include <chrono>
#include <memory>
#include <utility>

#include "experiments/drive/drive_messages.h"

namespace gmapping_spa::drive {
namespace {

std::string StartOfProgram() {
  return std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
}

}  // namespace

// A page that cannot keep up is told nothing until it has got what waits, and then all anew.
class DriveHub::Page : public view::Conversation {
 public:
  Page(view::Peer* peer, DriveHub* hub) : peer_(peer), hub_(hub) {
    hub_->pages_.insert(this);
    TellAll();
  }
  ~Page() override {
    hub_->pages_.erase(this);
    // Nobody lets go of the keys any more.
    hub_->controls_->Hold(0.0, 0.0);
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void Tell(const view::Messages& messages) {
    has_missed_something_ = has_missed_something_ || peer_->IsBehind();
    if (has_missed_something_) return;
    for (const view::MessagePtr& message : messages) peer_->Send(message);
  }
  void TellAll() {
    has_missed_something_ = false;
    for (const view::MessagePtr& message : hub_->All()) peer_->Send(message);
  }
  void OnMessage(std::string_view data, bool is_binary) override {
    TakeWish(data, is_binary, hub_->title_, hub_->controls_);
  }
  void OnDrained() override {
    if (has_missed_something_) TellAll();
  }

 private:
  view::Peer* peer_;
  DriveHub* hub_;
  bool has_missed_something_ = false;
};

DriveHub::DriveHub(DriveTitle title, const map::TrinaryMap& truth, DriveControls* controls)
    : session_(StartOfProgram()), title_(std::move(title)), controls_(controls) {
  const view::RunTitle run = {.name = "truth", .resolution_m = title_.truth_resolution_m};
  view::RunState& state = runs_.try_emplace(kTruthRun, kTruthRun, run).first->second;
  view::Snapshot snapshot;
  snapshot.figures.world_T_robot = title_.world_T_start;
  snapshot.finished_map = truth;
  state.Apply(std::move(snapshot));
}

std::vector<view::Protocol> DriveHub::Protocols() {
  return {{.name = "gmapping_spa.drive.v1",
           .begin = [this](view::Peer* peer) { return std::make_unique<Page>(peer, this); }}};
}

void DriveHub::Tell(const view::Messages& messages) const {
  for (Page* page : pages_) page->Tell(messages);
}

void DriveHub::TellAll() const {
  for (Page* page : pages_) page->TellAll();
}

view::Messages DriveHub::All() const {
  view::Messages messages = {HelloMessage(session_, title_, variants_)};
  for (const auto& [run, state] : runs_) {
    for (view::MessagePtr& message : state.All()) messages.push_back(std::move(message));
  }
  for (const auto& [run, variant] : variants_) messages.push_back(ScoresMessage(run, variant));
  messages.push_back(VariantsMessage(variants_));
  if (status_) messages.push_back(status_);
  return messages;
}

void DriveHub::Apply(int run, view::Snapshot snapshot) {
  const auto state = runs_.find(run);
  if (state == runs_.end()) return;  // removed meanwhile
  Tell(state->second.Apply(std::move(snapshot)));
}

void DriveHub::SetStatus(const DriveStatus& status) {
  status_ = StatusMessage(status);
  Tell({status_});
}

void DriveHub::AddVariant(int run, const VariantChoice& choice) {
  variants_[run] = {.choice = choice};
  const view::RunTitle title = {.name = NameOf(choice), .resolution_m = title_.map_resolution_m};
  runs_.erase(run);
  runs_.try_emplace(run, run, title);
  TellAll();
}

void DriveHub::RemoveVariant(int run) {
  variants_.erase(run);
  runs_.erase(run);
  TellAll();
}

void DriveHub::SetVariantState(int run, const std::string& state) {
  const auto variant = variants_.find(run);
  if (variant == variants_.end()) return;
  if (variant->second.state == "finished") AddVariant(run, VariantChoice(variant->second.choice));
  variants_[run].state = state;
  Tell({VariantsMessage(variants_)});
}

void DriveHub::SetScore(int run, const MapScore& score) {
  const auto variant = variants_.find(run);
  if (variant == variants_.end()) return;
  variant->second.score = score;
  // Before it has moved there is nothing to draw.
  if (score.ate_m || score.iou) variant->second.scores.Add(score);
  Tell({VariantsMessage(variants_)});
}

}  // namespace gmapping_spa::drive
