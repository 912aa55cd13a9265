// SPDX-License-Identifier: BSD-3-Clause
// Long calls that Ctrl-C ends, and threads that may outlive the call that started them.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_RUNNING_CALLS_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_RUNNING_CALLS_H_

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <thread>
#include <utility>

namespace gmapping_spa::python {

// While it lives, the interpreter does not end: a thread that is at work must not meet objects of
// Python or of the library that are gone already.
class RunningCall {
 public:
  // Throws std::runtime_error when the interpreter is about to end.
  RunningCall();
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;
};

// At the end of the interpreter waits for all RunningCalls, as it does for Python's own threads;
// another Ctrl-C ends the wait.
void WaitForRunningCallsAtExit();

// Throws pybind11::error_already_set when a handler of a signal raised, as Ctrl-C does. Takes the
// GIL for it.
void ThrowIfSignalRaised();

// Calls `work` in a thread of its own, without the GIL, and returns what it returns. When a signal
// raises in the meantime, the exception leaves at once, and what works is left to itself, up to its
// end: `work` owns all that it uses, and touches nothing of Python.
template <typename Function>
auto CallInterruptibly(Function work) {
  using Result = decltype(work());
  std::packaged_task<Result()> task([work = std::move(work)]() mutable {
    const RunningCall running;
    return work();
  });
  std::future<Result> result = task.get_future();
  const pybind11::gil_scoped_release release;
  std::thread thread(std::move(task));  // for want of memory, throws std::system_error
  try {
    while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
      ThrowIfSignalRaised();
    }
  } catch (...) {
    thread.detach();
    throw;
  }
  thread.join();
  return result.get();
}

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_RUNNING_CALLS_H_
