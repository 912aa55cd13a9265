// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/graph_thread.h"

#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <sstream>
#include <string>
#include <utility>

#include "backend/scheduling/optimize.h"

namespace gmapping_spa::frontend {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFinalPatience = 10.0;  // timeouts
constexpr auto kPatienceOnceAsked = std::chrono::seconds(2);
constexpr auto kTimeBetweenLooks = std::chrono::milliseconds(100);

Clock::duration Duration(double time_s) {
  constexpr double kLongest_s = 1e9;  // the clock's nanoseconds overflow at ten times as many
  return std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(std::min(time_s, kLongest_s)));
}

// An exception is a failure that says so.
backend::Summary OptimizeOrSayWhy(const GraphThread::OptimizeFunction& optimize,
                                  backend::PoseGraph* graph) {
  backend::Summary failure;
  try {
    return optimize(graph);
  } catch (const std::exception& error) {
    failure.message = std::string("it threw: ") + error.what();
  } catch (...) {
    failure.message = "it threw an exception of unknown type";
  }
  return failure;
}

}  // namespace

GraphThread::GraphThread(const Options& options, Health* health, OptimizeFunction optimize)
    : options_(options),
      health_(health),
      optimize_(std::make_shared<const OptimizeFunction>(std::move(optimize))) {
  CHECK_GE(options.lockstep_scans, 1);
}

GraphThread::~GraphThread() {
  if (busy() && !IsReadyWithin(options_.patience_s)) thread_.detach();
}

bool GraphThread::IsReadyWithin(double timeout_s) {
  const Clock::time_point end = Clock::now() + Duration(timeout_s);
  for (;;) {
    if (is_asked_to_stop_ && !end_of_waits_ && is_asked_to_stop_()) {
      end_of_waits_ = Clock::now() + kPatienceOnceAsked;
    }
    const Clock::time_point last = std::min(end, end_of_waits_.value_or(end));
    const Clock::time_point next =
        is_asked_to_stop_ ? std::min(last, Clock::now() + kTimeBetweenLooks) : last;
    if (result_.wait_until(next) == std::future_status::ready) return true;
    if (next == last) return false;
  }
}

void GraphThread::Start(backend::PoseGraph snapshot) {
  CHECK(!busy());
  snapshot_ = std::move(snapshot);
  state_before_ = StateOfOptimizer();
  Launch();
  ++counts_.started;
  scans_since_start_ = 0;
  late_ = false;
}

void GraphThread::Launch() {
  std::packaged_task<Result()> task([optimize = optimize_, graph = snapshot_]() mutable -> Result {
    backend::Summary summary = OptimizeOrSayWhy(*optimize, &graph);
    return {std::move(graph), std::move(summary)};
  });
  std::future<Result> result = task.get_future();
  thread_ = std::jthread(std::move(task));
  result_ = std::move(result);
}

std::optional<backend::PoseGraph> GraphThread::TakeIfDue(double stamp_s) {
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
    message << "the back end has not answered within ";
    if (end_of_waits_) {
      message << "the time left since the program was asked to end";
    } else {
      message << timeout_s << " s";
    }
    message << "; going on without";
    health_->Report("backend_late", stamp_s_, message.str());
    late_ = true;
    ++counts_.late;
  }
  return optimized;
}

std::optional<backend::PoseGraph> GraphThread::Take(double wait_s) {
  if (!IsReadyWithin(wait_s)) return std::nullopt;
  Result result = result_.get();
  const backend::Summary& summary = result.summary;
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
  latest_cost_ = summary.final_cost;
  rejected_closures_.clear();
  for (const std::size_t k : backend::RejectedClosures(result.graph.edges, summary)) {
    const backend::Edge& edge = result.graph.edges[k];
    rejected_closures_.push_back({edge.i, edge.j, summary.edge_weights[k]});
  }
  return std::move(result.graph);
}

}  // namespace gmapping_spa::frontend
