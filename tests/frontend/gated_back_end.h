// SPDX-License-Identifier: BSD-3-Clause
// A back end that a test lets go on, and what a graph thread does with it.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_GATED_BACK_END_H_
#define GMAPPING_SPA_TESTS_FRONTEND_GATED_BACK_END_H_

#include <chrono>
#include <memory>
#include <optional>
#include <semaphore>
#include <thread>

#include "frontend/graph_thread.h"

namespace gmapping_spa::frontend {

inline backend::Summary Ended(backend::Termination termination) {
  backend::Summary summary;
  summary.termination = termination;
  return summary;
}

// It works for as long as the test wants: each call waits for one Allow(), then moves node 0 by a
// metre.
class GatedBackEnd {
 public:
  GraphThread::OptimizeFunction Function() const {
    return [state = state_](backend::PoseGraph* graph) {
      state->allowed.acquire();
      graph->nodes.at(0).world_T_node.x += 1.0;
      return Ended(backend::Termination::kConverged);
    };
  }
  void Allow(int calls = 1) const { state_->allowed.release(calls); }

 private:
  struct State {
    std::counting_semaphore<> allowed{0};
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

inline backend::PoseGraph GraphAt(double x) {
  return {.nodes = {{.world_T_node = {x, 0, 0}}}, .edges = {}};
}

inline double XOf(const backend::PoseGraph& graph) { return graph.nodes.at(0).world_T_node.x; }

inline GraphThread::Options Lockstep(int scans, double timeout_s = 60.0) {
  return {GraphThread::Mode::kLockstep, scans, timeout_s};
}

// Tries until a result comes, for five seconds at most.
inline std::optional<backend::PoseGraph> TryUntilTaken(GraphThread* thread) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::chrono::steady_clock::now() < deadline) {
    if (auto graph = thread->TakeIfDue(0.0)) return graph;
    std::this_thread::yield();
  }
  return std::nullopt;
}

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_TESTS_FRONTEND_GATED_BACK_END_H_
