// SPDX-License-Identifier: BSD-3-Clause
// All that is known of a run, and what a new snapshot changes of it.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_RUN_STATE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_RUN_STATE_H_

#include <memory>

#include "experiments/view/message.h"
#include "experiments/view/page_messages.h"
#include "experiments/view/snapshot.h"
#include "experiments/view/tile_differ.h"

namespace gmapping_spa::view {

class RunState {
 public:
  RunState(int run, RunTitle title);

  const RunTitle& title() const { return title_; }

  // What a page has to be told that knows the state so far: only what changed.
  Messages Apply(Snapshot snapshot);

  // What a new page has to be told; nothing before the first snapshot.
  Messages All() const;

  // Nobody looks: see TileDiffer.
  void ReleaseGrid() { differ_.ReleaseGrid(); }

  // What is known by now; all empty before the first snapshot. The latest one has no map and no
  // graph: these are what is below.
  const Snapshot& latest() const { return latest_; }
  const GraphSnapshot& graph() const { return *graph_; }
  const TileImages& tiles() const { return differ_.images(); }

  // How often each of it has changed.
  struct Revisions {
    int frame = 0;
    int map = 0;
    int graph = 0;
    int health = 0;
  };
  const Revisions& revisions() const { return revisions_; }

 private:
  void ApplyGraph(const std::shared_ptr<const GraphSnapshot>& graph, Messages* messages);
  TileImages ApplyMap(const Snapshot& snapshot);

  int run_;
  RunTitle title_;
  TileDiffer differ_;
  Snapshot latest_;
  std::shared_ptr<const GraphSnapshot> graph_;
  backend::Trajectory trajectory_;
  Revisions revisions_;
  MessagePtr frame_, health_;  // null before the first snapshot
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_RUN_STATE_H_
