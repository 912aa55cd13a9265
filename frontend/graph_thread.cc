#include "frontend/graph_thread.h"

#include <glog/logging.h>

#include <sstream>
#include <utility>

namespace gmapping_spa::frontend {
namespace {

constexpr double kFinalPatience = 10.0;  // timeouts

}  // namespace

GraphThread::GraphThread(const Options& options, Health* health,
                         backend::OptimizationThread::OptimizeFunction optimize)
    : options_(options), health_(health), thread_(std::move(optimize)) {
  CHECK_GE(options.lockstep_scans, 1);
}

void GraphThread::Start(backend::PoseGraph snapshot) {
  thread_.Start(std::move(snapshot));
  ++counts_.started;
  scans_since_start_ = 0;
  late_ = false;
}

std::optional<backend::PoseGraph> GraphThread::Advance(double stamp_s) {
  stamp_s_ = stamp_s;
  if (!busy()) return std::nullopt;
  ++scans_since_start_;
  if (options_.mode == Mode::kAsync || late_) return Take(0.0);
  const int due = options_.mode == Mode::kInline ? 1 : options_.lockstep_scans;
  if (scans_since_start_ < due) return std::nullopt;
  return WaitFor(options_.timeout_s);
}

std::optional<backend::PoseGraph> GraphThread::Finish() {
  return busy() ? WaitFor(kFinalPatience * options_.timeout_s) : std::nullopt;
}

std::optional<backend::PoseGraph> GraphThread::Run(backend::PoseGraph snapshot) {
  if (busy()) {
    health_->Report("backend_busy", stamp_s_,
                    "the back end still has an earlier graph: an optimization is left out");
    return std::nullopt;
  }
  Start(std::move(snapshot));
  return Finish();
}

// Takes what is due. What does not come in time is late, and waited for no more.
std::optional<backend::PoseGraph> GraphThread::WaitFor(double timeout_s) {
  std::optional<backend::PoseGraph> optimized = Take(timeout_s);
  if (busy()) {
    std::ostringstream message;
    message << "the back end has not answered within " << timeout_s << " s; going on without";
    health_->Report("backend_late", stamp_s_, message.str());
    late_ = true;
    ++counts_.late;
  }
  return optimized;
}

std::optional<backend::PoseGraph> GraphThread::Take(double wait_s) {
  std::optional<backend::OptimizationThread::Result> result = thread_.Wait(wait_s);
  if (!result) return std::nullopt;
  const backend::Summary& summary = result->summary;
  if (summary.termination == backend::Termination::kFailure) {
    health_->Report("backend_failed", stamp_s_, "the back end failed: " + summary.message);
    ++counts_.failed;
    return std::nullopt;
  }
  if (summary.termination == backend::Termination::kNoConvergence) {
    health_->Report("backend_not_converged", stamp_s_,
                    "the back end ended before it had converged: " + summary.message);
  }
  ++counts_.taken;
  return std::move(result->graph);
}

}  // namespace gmapping_spa::frontend
