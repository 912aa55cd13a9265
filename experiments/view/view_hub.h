// SPDX-License-Identifier: BSD-3-Clause
// Who looks, and what there is to see. In the server's thread, but for the constructor.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_VIEW_HUB_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_VIEW_HUB_H_

#include <set>
#include <string>
#include <vector>

#include "experiments/view/conversation.h"
#include "experiments/view/figure_history.h"
#include "experiments/view/pause_gate.h"
#include "experiments/view/run_state.h"

namespace gmapping_spa::view {

class PageConversation;
class FoxgloveConversation;

struct ViewedRun {
  RunTitle title;
  const FigureHistory* history = nullptr;
};

class ViewHub {
 public:
  // What is pointed to outlives this; the gate is null where there is nothing to pause.
  ViewHub(const std::vector<ViewedRun>& runs, PauseGate* gate);

  // The page's own and Foxglove's. Conversations begun end before this does.
  std::vector<Protocol> Protocols();

  // Tells everybody what is new.
  void Apply(int run, Snapshot snapshot);

  // Of conversations.
  void Add(PageConversation* page) { pages_.insert(page); }
  void Add(FoxgloveConversation* client) { foxglove_clients_.insert(client); }
  void Remove(PageConversation* page);
  void Remove(FoxgloveConversation* client);
  Messages All() const;
  const RunState& first_run() const { return states_.front(); }
  // Null where there is nothing to pause.
  PauseGate* gate() const { return gate_; }
  void TellOfControl() const;

 private:
  void ReleaseUnlessSeen();

  std::string session_;
  std::vector<RunState> states_;
  std::vector<const FigureHistory*> histories_;
  PauseGate* gate_;
  std::set<PageConversation*> pages_;
  std::set<FoxgloveConversation*> foxglove_clients_;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_VIEW_HUB_H_
