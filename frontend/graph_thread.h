// When the back end runs and when its result is taken over.
#ifndef GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_
#define GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "backend/scheduling/optimization_thread.h"

namespace gmapping_spa::frontend {

// Step 3': the graph thread of the paper. A back end that fails, throws or hangs costs its result
// and a warning, no more.
class GraphThread {
 public:
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
    friend bool operator==(const Options&, const Options&) = default;
  };

  struct Counts {
    std::int64_t started = 0;
    std::int64_t taken = 0;
    std::int64_t failed = 0;
    std::int64_t late = 0;  // not there when they were due
  };

  GraphThread(const Options& options, backend::OptimizationThread::OptimizeFunction optimize);

  bool busy() const { return thread_.busy(); }

  // Precondition: not busy.
  void Start(backend::PoseGraph snapshot);

  // Call it once a scan: the optimized snapshot when it is due and a success.
  std::optional<backend::PoseGraph> Advance();

  // What runs, now: nothing else is left to do, so that ten times the timeout is waited for.
  std::optional<backend::PoseGraph> Finish();

  // Starts and finishes. Nothing when the back end is still busy with another snapshot.
  std::optional<backend::PoseGraph> Run(backend::PoseGraph snapshot);

  // The loop closures that the last result rejects, with their weights: see backend::Summary.
  struct RejectedClosure {
    std::int64_t i = 0, j = 0;  // ids of the nodes
    double weight = 0.0;
  };
  const std::vector<RejectedClosure>& rejected_closures() const { return rejected_closures_; }

  const Counts& counts() const { return counts_; }

 private:
  std::optional<backend::PoseGraph> WaitFor(double timeout_s);
  std::optional<backend::PoseGraph> Take(double wait_s);

  Options options_;
  backend::OptimizationThread thread_;
  int scans_since_start_ = 0;
  bool late_ = false;
  std::vector<RejectedClosure> rejected_closures_;
  Counts counts_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_
