// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/run_state.h"

#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "experiments/view/tile_message.h"

namespace gmapping_spa::view {
namespace {

using loop_closure::ClosureRecord;

bool SamePose(const backend::StampedPose& a, const backend::StampedPose& b) {
  return a.stamp_s == b.stamp_s && a.world_T_robot == b.world_T_robot;
}

// Those poses that differ are sent, and all behind them.
std::size_t CountSame(const backend::Trajectory& a, const backend::Trajectory& b) {
  std::size_t same = 0;
  while (same < a.size() && same < b.size() && SamePose(a[same], b[same])) ++same;
  return same;
}

// Candidates are appended, and may get another verdict later.
std::vector<std::size_t> Changed(const std::vector<ClosureRecord>& before,
                                 const std::vector<ClosureRecord>& after) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const bool same = i < before.size() && before[i].verdict == after[i].verdict &&
                      before[i].old_node == after[i].old_node && before[i].node == after[i].node;
    if (!same) positions.push_back(i);
  }
  return positions;
}

std::span<const backend::StampedPose> From(const backend::Trajectory& poses, std::size_t first) {
  return std::span(poses).subspan(first);
}

}  // namespace

RunState::RunState(int run, RunTitle title)
    : run_(run), title_(std::move(title)), graph_(std::make_shared<const GraphSnapshot>()) {}

TileImages RunState::ApplyMap(const Snapshot& snapshot) {
  if (snapshot.grid) return differ_.Update(*snapshot.grid);
  return snapshot.finished_map ? differ_.Update(*snapshot.finished_map) : TileImages{};
}

void RunState::ApplyGraph(const std::shared_ptr<const GraphSnapshot>& graph, Messages* messages) {
  const std::size_t same = CountSame(graph_->nodes, graph->nodes);
  if (same < graph->nodes.size() || same < graph_->nodes.size()) {
    messages->push_back(PosesMessage("nodes", run_, same, From(graph->nodes, same)));
  }
  const std::vector<std::size_t> changed = Changed(graph_->candidates, graph->candidates);
  if (!changed.empty()) {
    messages->push_back(CandidatesMessage(run_, graph->candidates, changed));
  }
  graph_ = graph;
  ++revisions_.graph;
}

Messages RunState::Apply(Snapshot snapshot) {
  Messages messages = TileMessages(run_, snapshot.figures.stamp_s, ApplyMap(snapshot));
  if (!messages.empty()) ++revisions_.map;
  if (snapshot.graph) ApplyGraph(snapshot.graph, &messages);
  if (!snapshot.trajectory.empty()) {
    trajectory_ = snapshot.trajectory;
    messages.push_back(PosesMessage("trajectory", run_, 0, trajectory_));
  }
  const MessagePtr health = HealthMessage(run_, snapshot.health);
  if (!health_ || health->data != health_->data) {
    messages.push_back(health);
    ++revisions_.health;
  }
  health_ = health;
  // The last of all, so that a frame is drawn with what belongs to it.
  frame_ = FrameMessage(run_, snapshot);
  messages.push_back(frame_);
  ++revisions_.frame;
  latest_ = std::move(snapshot);
  latest_.grid.reset();
  latest_.finished_map.reset();
  latest_.graph.reset();
  return messages;
}

Messages RunState::All() const {
  if (!frame_) return {};
  Messages messages = TileMessages(run_, latest_.figures.stamp_s, differ_.images());
  messages.push_back(PosesMessage("nodes", run_, 0, graph_->nodes));
  if (!trajectory_.empty()) messages.push_back(PosesMessage("trajectory", run_, 0, trajectory_));
  std::vector<std::size_t> positions(graph_->candidates.size());
  std::iota(positions.begin(), positions.end(), std::size_t{0});
  messages.push_back(CandidatesMessage(run_, graph_->candidates, positions));
  messages.push_back(health_);
  messages.push_back(frame_);
  return messages;
}

}  // namespace gmapping_spa::view
