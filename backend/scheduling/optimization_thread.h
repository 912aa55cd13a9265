// Optimizing a pose graph while the front end goes on.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZATION_THREAD_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZATION_THREAD_H_

#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "backend/graph/pose_graph.h"
#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// A thread that optimizes snapshots of a pose graph, one at a time. Whatever the optimization does,
// no call waits longer than it says. Use one object in one thread at a time.
class OptimizationThread {
 public:
  // Optimizes in place, such as OptimizeSafely or OptimizeGradually bound to an optimizer. It owns
  // what it uses, because it may outlive the OptimizationThread: bind a shared_ptr.
  using OptimizeFunction = std::function<Summary(PoseGraph*)>;

  struct Result {
    PoseGraph graph;  // the optimized snapshot; after a failure, the snapshot as it was
    // The function's; when it throws, a failure whose message says what, with costs of 0.
    Summary summary;
  };

  // Throws std::system_error when there is no thread to be had.
  explicit OptimizationThread(OptimizeFunction optimize, double patience_s = 5.0);
  // Waits up to patience_s for a running optimization. One that takes longer is left to itself: its
  // thread ends with it, and the function is destroyed there. Otherwise the thread has ended.
  ~OptimizationThread();
  OptimizationThread(const OptimizationThread&) = delete;
  OptimizationThread& operator=(const OptimizationThread&) = delete;

  // Whether there is a snapshot whose result has not been taken.
  bool busy() const;
  // Begins to optimize. Throws std::logic_error when busy.
  void Start(PoseGraph snapshot);
  // Takes the result if it is there. Does not wait.
  std::optional<Result> Poll();
  // Takes the result, waiting for it up to timeout_s; when not busy, returns nothing at once. After
  // a timeout the optimization goes on and its result can still be taken.
  std::optional<Result> Wait(double timeout_s);

 private:
  struct State;

  // Shared with the worker, which may be the last to use it.
  std::shared_ptr<State> state_;
  double patience_s_;
  std::thread worker_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZATION_THREAD_H_
