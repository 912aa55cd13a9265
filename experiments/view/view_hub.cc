// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/view_hub.h"

#include <chrono>
#include <memory>
#include <utility>

#include "experiments/view/foxglove_conversation.h"
#include "experiments/view/page_conversation.h"

namespace gmapping_spa::view {
namespace {

std::string NewSession() {
  return std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
}

}  // namespace

ViewHub::ViewHub(const std::vector<ViewedRun>& runs, PauseGate* gate)
    : session_(NewSession()), gate_(gate) {
  for (const ViewedRun& run : runs) {
    states_.emplace_back(static_cast<int>(states_.size()), run.title);
    histories_.push_back(run.history);
  }
}

std::vector<Protocol> ViewHub::Protocols() {
  return {{.name = "gmapping_spa.view.v1",
           .begin = [this](Peer* peer) { return std::make_unique<PageConversation>(peer, this); }},
          {.name = "foxglove.websocket.v1", .only_reads = true, .begin = [this](Peer* peer) {
             return std::make_unique<FoxgloveConversation>(peer, this);
           }}};
}

void ViewHub::Apply(int run, Snapshot snapshot) {
  const Messages messages = states_.at(run).Apply(std::move(snapshot));
  for (PageConversation* page : pages_) page->Tell(messages);
  for (FoxgloveConversation* client : foxglove_clients_) client->TellNews();
  ReleaseUnlessSeen();
}

void ViewHub::Remove(PageConversation* page) {
  pages_.erase(page);
  ReleaseUnlessSeen();
}

void ViewHub::Remove(FoxgloveConversation* client) {
  foxglove_clients_.erase(client);
  ReleaseUnlessSeen();
}

void ViewHub::ReleaseUnlessSeen() {
  if (!pages_.empty() || !foxglove_clients_.empty()) return;
  for (RunState& state : states_) state.ReleaseGrid();
}

Messages ViewHub::All() const {
  std::vector<RunTitle> titles;
  for (const RunState& state : states_) titles.push_back(state.title());
  Messages messages = {HelloMessage(session_, titles)};
  for (std::size_t run = 0; run < states_.size(); ++run) {
    messages.push_back(HistoryMessage(static_cast<int>(run), histories_[run]->Rows()));
    for (MessagePtr& message : states_[run].All()) messages.push_back(std::move(message));
  }
  if (gate_ != nullptr) messages.push_back(ControlMessage(gate_->is_paused()));
  return messages;
}

void ViewHub::TellOfControl() const {
  const Messages messages = {ControlMessage(gate_->is_paused())};
  for (PageConversation* page : pages_) page->Tell(messages);
}

}  // namespace gmapping_spa::view
