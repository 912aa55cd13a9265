// SPDX-License-Identifier: BSD-3-Clause
// When the back end runs and when its result is taken over.
#ifndef GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_
#define GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "backend/plugin/optimizer.h"
#include "frontend/health.h"

namespace gmapping_spa::frontend {

// Step 3': the graph thread of the paper. It optimizes snapshots of the graph, one at a time. A
// back end that fails, throws or hangs costs its result, no more. That is reported to health as
// backend_failed or backend_late; as backend_not_converged what ended for want of iterations or
// time, and as backend_busy what never ran for that.
class GraphThread {
 public:
  // Optimizes in place, such as OptimizeSafely or OptimizeGradually bound to an optimizer. It owns
  // what it uses, because a call that hangs outlives the GraphThread: bind a shared_ptr.
  using OptimizeFunction = std::function<backend::Summary(backend::PoseGraph*)>;

  enum class Mode : std::uint8_t {
    kLockstep,  // taken over a fixed number of scans after the start: concurrent and repeatable
    kAsync,     // as soon as it is there
    kInline     // at the scan after the start, however long it takes
  };

  struct Options {
    Mode mode = Mode::kLockstep;
    int lockstep_scans = 10;
    // A result that is due and not there after this long is waited for no longer: it is taken over
    // when it comes.
    double timeout_s = 3.0;
    // For how long the destructor waits for what runs.
    double patience_s = 5.0;
    friend bool operator==(const Options&, const Options&) = default;
  };

  struct Counts {
    std::int64_t started = 0;
    std::int64_t taken = 0;
    std::int64_t failed = 0;
    std::int64_t late = 0;  // not there when they were due

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(started, taken, failed, late);
    }
  };

  // `health` outlives this.
  GraphThread(const Options& options, Health* health, OptimizeFunction optimize);
  // What runs for longer than patience_s is left to itself: its thread ends with it, and the
  // function is destroyed there. Otherwise the thread has ended.
  ~GraphThread();
  GraphThread(const GraphThread&) = delete;
  GraphThread& operator=(const GraphThread&) = delete;

  // From when `is_asked` returns true, all waits together last two seconds at most: for users who
  // want the program to end. It is called a few times a second.
  void StopWaitingWhen(std::function<bool()> is_asked) { is_asked_to_stop_ = std::move(is_asked); }

  // The optimizer that the function calls: what it keeps between calls is then part of sessions.
  void KeepStateOf(std::shared_ptr<backend::Optimizer> optimizer) {
    optimizer_ = std::move(optimizer);
  }

  // Whether there is a snapshot whose result has not been taken.
  bool busy() const { return result_.valid(); }

  // Precondition: not busy. Throws std::system_error when there is no thread to be had.
  void Start(backend::PoseGraph snapshot);

  // Call it once a scan, with its stamp: the optimized snapshot when it is due and a success.
  std::optional<backend::PoseGraph> TakeIfDue(double stamp_s);

  // What runs, now: nothing else is left to do, so that ten times the timeout is waited for.
  std::optional<backend::PoseGraph> Finish();

  // Starts and finishes. Nothing when the back end is still busy with another snapshot.
  std::optional<backend::PoseGraph> Run(backend::PoseGraph snapshot);

  // The loop closures that the last result rejects, with their weights: see backend::Summary.
  struct RejectedClosure {
    std::int64_t i = 0, j = 0;  // ids of the nodes
    double weight = 0.0;

    template <typename Archive>
    void serialize(Archive& archive) {
      archive(i, j, weight);
    }
  };
  const std::vector<RejectedClosure>& rejected_closures() const { return rejected_closures_; }

  // Of the last result taken; nothing before the first one.
  std::optional<double> latest_cost() const { return latest_cost_; }

  const Counts& counts() const { return counts_; }

  // For sessions (frontend/session). What runs is begun again from its snapshot.
  template <typename Archive>
  void serialize(Archive& archive) {
    bool is_busy = busy();
    std::optional<std::string> state = is_busy ? state_before_ : StateOfOptimizer();
    archive(stamp_s_, scans_since_start_, late_, rejected_closures_, counts_, is_busy, state);
    if (is_busy) archive(snapshot_);
    if constexpr (Archive::is_loading::value) {
      if (state && optimizer_) optimizer_->SetState(*state);
      state_before_ = std::move(state);
      if (is_busy) Launch();
    }
  }

 private:
  struct Result {
    backend::PoseGraph graph;
    backend::Summary summary;
  };

  std::optional<backend::PoseGraph> WaitFor(double timeout_s);
  std::optional<backend::PoseGraph> Take(double wait_s);
  bool IsReadyWithin(double timeout_s);
  void Launch();  // with snapshot_
  std::optional<std::string> StateOfOptimizer() const {
    return optimizer_ ? optimizer_->State() : std::nullopt;
  }

  Options options_;
  Health* health_;
  double stamp_s_ = 0.0;                              // of the latest scan
  std::shared_ptr<const OptimizeFunction> optimize_;  // shared with what is left to itself
  std::shared_ptr<backend::Optimizer> optimizer_;
  // Of what runs.
  backend::PoseGraph snapshot_;
  std::optional<std::string> state_before_;  // of the optimizer
  std::future<Result> result_;
  std::jthread thread_;
  int scans_since_start_ = 0;
  bool late_ = false;
  std::function<bool()> is_asked_to_stop_;
  std::optional<std::chrono::steady_clock::time_point> end_of_waits_;  // once it has been asked
  std::vector<RejectedClosure> rejected_closures_;
  std::optional<double> latest_cost_;
  Counts counts_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_
