// SPDX-License-Identifier: BSD-3-Clause
// With Foxglove, in its WebSocket protocol v1 (github.com/foxglove/ws-protocol): the first run.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_CONVERSATION_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_CONVERSATION_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>

#include <nlohmann/json.hpp>

#include "experiments/view/conversation.h"
#include "experiments/view/view_hub.h"

namespace gmapping_spa::view {

class FoxgloveConversation : public Conversation {
 public:
  FoxgloveConversation(Peer* peer, ViewHub* hub);
  ~FoxgloveConversation() override;
  FoxgloveConversation(const FoxgloveConversation&) = delete;
  FoxgloveConversation& operator=(const FoxgloveConversation&) = delete;

  // Sends what is new on the topics subscribed to; nothing as long as the client cannot keep up.
  void TellNews();

  // "subscribe" and "unsubscribe"; anything else is answered by a status. Throws on what is no
  // JSON.
  void OnMessage(std::string_view data, bool is_binary) override;
  void OnDrained() override { TellNews(); }

 private:
  struct Subscription {
    std::size_t channel = 0;
    int revision = 0;  // that was sent
    std::chrono::steady_clock::time_point sent;
  };

  void Subscribe(const nlohmann::json& message);
  void Unsubscribe(const nlohmann::json& message);
  void Send(std::uint32_t id, Subscription* subscription);
  void Complain(const char* text);

  Peer* peer_;
  ViewHub* hub_;
  std::map<std::uint32_t, Subscription> subscriptions_;  // by the client's ids
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FOXGLOVE_CONVERSATION_H_
