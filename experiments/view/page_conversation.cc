// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/page_conversation.h"

#include <stdexcept>
#include <string>

#include "experiments/view/client_message.h"

namespace gmapping_spa::view {

PageConversation::PageConversation(Peer* peer, ViewHub* hub) : peer_(peer), hub_(hub) {
  hub_->Add(this);
  TellAll();
}

PageConversation::~PageConversation() { hub_->Remove(this); }

void PageConversation::TellAll() {
  has_missed_something_ = false;
  for (const MessagePtr& message : hub_->All()) peer_->Send(message);
}

void PageConversation::Tell(const Messages& messages) {
  has_missed_something_ = has_missed_something_ || peer_->IsBehind();
  if (has_missed_something_) return;
  for (const MessagePtr& message : messages) peer_->Send(message);
}

void PageConversation::OnDrained() {
  if (has_missed_something_) TellAll();
}

void PageConversation::OnMessage(std::string_view data, bool is_binary) {
  const std::string op = ParseClientMessage(data, is_binary).at("op").get<std::string>();
  PauseGate* gate = hub_->gate();
  if (gate == nullptr) throw std::runtime_error("there is nothing to pause");
  if (op == "pause") {
    gate->Pause();
  } else if (op == "resume") {
    gate->Resume();
  } else if (op == "step") {
    gate->Step();
  } else {
    throw std::runtime_error("expected pause, resume or step");
  }
  hub_->TellOfControl();
}

}  // namespace gmapping_spa::view
