// When the back end runs and when its result is taken over.
#ifndef GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_
#define GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_

#include <cstdint>
#include <optional>

#include "backend/scheduling/optimization_thread.h"
#include "frontend/health.h"

namespace gmapping_spa::frontend {

// Step 3': the graph thread of the paper. A back end that fails, throws or hangs costs its result,
// no more. That is reported to health as backend_failed or backend_late; as backend_not_converged
// what ended for want of iterations or time, and as backend_busy what never ran for that.
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

  // `health` outlives this.
  GraphThread(const Options& options, Health* health,
              backend::OptimizationThread::OptimizeFunction optimize);

  bool busy() const { return thread_.busy(); }

  // Precondition: not busy.
  void Start(backend::PoseGraph snapshot);

  // Call it once a scan, with its stamp: the optimized snapshot when it is due and a success.
  std::optional<backend::PoseGraph> Advance(double stamp_s);

  // What runs, now: nothing else is left to do, so that ten times the timeout is waited for.
  std::optional<backend::PoseGraph> Finish();

  // Starts and finishes. Nothing when the back end is still busy with another snapshot.
  std::optional<backend::PoseGraph> Run(backend::PoseGraph snapshot);

  const Counts& counts() const { return counts_; }

 private:
  std::optional<backend::PoseGraph> WaitFor(double timeout_s);
  std::optional<backend::PoseGraph> Take(double wait_s);

  Options options_;
  Health* health_;
  backend::OptimizationThread thread_;
  double stamp_s_ = 0.0;  // of the latest scan
  int scans_since_start_ = 0;
  bool late_ = false;
  Counts counts_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_GRAPH_THREAD_H_
