// SPDX-License-Identifier: BSD-3-Clause
// What is spoken over a WebSocket, apart from how. All calls are made in the server's thread.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_CONVERSATION_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_CONVERSATION_H_

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "experiments/view/message.h"

namespace gmapping_spa::view {

// The other end.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void Send(MessagePtr message) = 0;
  // Whether so much waits to be sent that more should not be added: Conversation::OnDrained tells
  // when nothing waits any more.
  virtual bool IsBehind() const = 0;
};

// One with a peer, from when it is there to when it has gone.
class Conversation {
 public:
  virtual ~Conversation() = default;
  // Of at most ServerOptions::max_message_bytes. What it throws ends the conversation.
  virtual void OnMessage(std::string_view data, bool is_binary) = 0;
  virtual void OnDrained() = 0;
};

// A language by its name in Sec-WebSocket-Protocol.
struct Protocol {
  std::string name;
  // Whether pages of ServerOptions::reading_origins may speak it; it must not steer anything then.
  bool only_reads = false;
  // `peer` outlives the conversation.
  std::function<std::unique_ptr<Conversation>(Peer* peer)> begin;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_CONVERSATION_H_
