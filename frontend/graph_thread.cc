#include "frontend/graph_thread.h"

#include <glog/logging.h>

#include <utility>

#include "backend/scheduling/optimize.h"

namespace gmapping_spa::frontend {
namespace {

constexpr double kFinalPatience = 10.0;  // timeouts

}  // namespace

GraphThread::GraphThread(const Options& options,
                         backend::OptimizationThread::OptimizeFunction optimize)
    : options_(options), thread_(std::move(optimize)) {
  CHECK_GE(options.lockstep_scans, 1);
}

void GraphThread::Start(backend::PoseGraph snapshot) {
  thread_.Start(std::move(snapshot));
  ++counts_.started;
  scans_since_start_ = 0;
  late_ = false;
}

std::optional<backend::PoseGraph> GraphThread::Advance() {
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
  if (busy()) return std::nullopt;
  Start(std::move(snapshot));
  return Finish();
}

// Takes what is due. What does not come in time is late, and waited for no more.
std::optional<backend::PoseGraph> GraphThread::WaitFor(double timeout_s) {
  std::optional<backend::PoseGraph> optimized = Take(timeout_s);
  if (busy()) {
    LOG(WARNING) << "the back end has not answered within " << timeout_s << " s; going on without";
    late_ = true;
    ++counts_.late;
  }
  return optimized;
}

std::optional<backend::PoseGraph> GraphThread::Take(double wait_s) {
  std::optional<backend::OptimizationThread::Result> result = thread_.Wait(wait_s);
  if (!result) return std::nullopt;
  if (result->summary.termination == backend::Termination::kFailure) {
    LOG(WARNING) << "the back end failed: " << result->summary.message;
    ++counts_.failed;
    return std::nullopt;
  }
  ++counts_.taken;
  rejected_closures_.clear();
  for (const std::size_t k : backend::RejectedClosures(result->graph.edges, result->summary)) {
    const backend::Edge& edge = result->graph.edges[k];
    rejected_closures_.push_back({edge.i, edge.j, result->summary.edge_weights[k]});
  }
  return std::move(result->graph);
}

}  // namespace gmapping_spa::frontend
