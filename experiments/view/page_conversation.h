// SPDX-License-Identifier: BSD-3-Clause
// With a page: tells it all that changes, and takes its wishes to pause.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_CONVERSATION_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_CONVERSATION_H_

#include <string_view>

#include "experiments/view/conversation.h"
#include "experiments/view/message.h"
#include "experiments/view/view_hub.h"

namespace gmapping_spa::view {

class PageConversation : public Conversation {
 public:
  PageConversation(Peer* peer, ViewHub* hub);
  ~PageConversation() override;
  PageConversation(const PageConversation&) = delete;
  PageConversation& operator=(const PageConversation&) = delete;

  // A page that cannot keep up is told nothing until it has got what waits, and then all anew.
  void Tell(const Messages& messages);

  // {"op": "pause"}, "resume" or "step". Throws std::runtime_error on anything else.
  void OnMessage(std::string_view data, bool is_binary) override;
  void OnDrained() override;

 private:
  void TellAll();

  Peer* peer_;
  ViewHub* hub_;
  bool has_missed_something_ = false;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_CONVERSATION_H_
