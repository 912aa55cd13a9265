#include "backend/scheduling/optimization_thread.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

namespace gmapping_spa::backend {
namespace {

enum class Stage : std::uint8_t {
  kIdle,
  kStarted,  // the worker has not yet taken the snapshot
  kRunning,
  kDone  // the result has not yet been taken
};

OptimizationThread::Result Run(const OptimizationThread::OptimizeFunction& optimize,
                               PoseGraph snapshot) {
  OptimizationThread::Result result;  // a failure until the function says otherwise
  try {
    result.graph = snapshot;
    result.summary = optimize(&result.graph);
  } catch (const std::exception& error) {
    result.summary.message = std::string("it threw: ") + error.what();
  } catch (...) {
    result.summary.message = "it threw an exception of unknown type";
  }
  if (result.summary.termination == Termination::kFailure) result.graph = std::move(snapshot);
  return result;
}

// Like condition_variable::wait_for, which runs by the steady clock, for any number of seconds.
template <typename Predicate>
bool WaitFor(std::condition_variable* condition, std::unique_lock<std::mutex>* lock,
             double timeout_s, Predicate predicate) {
  constexpr double kLongest_s = 1e9;  // the clock's nanoseconds overflow at ten times as many
  const std::chrono::duration<double> timeout(std::max(0.0, std::min(timeout_s, kLongest_s)));
  return condition->wait_for(*lock, timeout, predicate);
}

}  // namespace

struct OptimizationThread::State {
  explicit State(OptimizeFunction the_function) : optimize(std::move(the_function)) {}

  // What the thread does until `stop`.
  void Work();

  const OptimizeFunction optimize;
  std::mutex mutex;
  std::condition_variable changed;  // stage or stop
  // Guarded by the mutex.
  Stage stage = Stage::kIdle;
  bool stop = false;
  PoseGraph snapshot;  // when kStarted
  Result result;       // when kDone
};

void OptimizationThread::State::Work() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [this] { return stop || stage == Stage::kStarted; });
    if (stop) return;
    stage = Stage::kRunning;
    PoseGraph taken = std::move(snapshot);
    lock.unlock();
    Result done = Run(optimize, std::move(taken));
    lock.lock();
    result = std::move(done);
    stage = Stage::kDone;
    changed.notify_all();
  }
}

OptimizationThread::OptimizationThread(OptimizeFunction optimize, double patience_s)
    : state_(std::make_shared<State>(std::move(optimize))),
      patience_s_(patience_s),
      worker_([state = state_] { state->Work(); }) {}

OptimizationThread::~OptimizationThread() {
  std::unique_lock lock(state_->mutex);
  state_->stop = true;
  state_->changed.notify_all();
  const bool will_end = WaitFor(&state_->changed, &lock, patience_s_,
                                [this] { return state_->stage != Stage::kRunning; });
  lock.unlock();
  if (will_end) {
    worker_.join();
  } else {
    worker_.detach();
  }
}

bool OptimizationThread::busy() const {
  const std::lock_guard lock(state_->mutex);
  return state_->stage != Stage::kIdle;
}

void OptimizationThread::Start(PoseGraph snapshot) {
  const std::lock_guard lock(state_->mutex);
  if (state_->stage != Stage::kIdle) throw std::logic_error("an optimization is under way");
  state_->snapshot = std::move(snapshot);
  state_->stage = Stage::kStarted;
  state_->changed.notify_all();
}

std::optional<OptimizationThread::Result> OptimizationThread::Poll() { return Wait(0.0); }

std::optional<OptimizationThread::Result> OptimizationThread::Wait(double timeout_s) {
  std::unique_lock lock(state_->mutex);
  WaitFor(&state_->changed, &lock, timeout_s,
          [this] { return state_->stage == Stage::kIdle || state_->stage == Stage::kDone; });
  if (state_->stage != Stage::kDone) return std::nullopt;
  state_->stage = Stage::kIdle;
  return std::move(state_->result);
}

}  // namespace gmapping_spa::backend
