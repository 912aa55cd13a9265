// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/python/running_calls.h"

#include <condition_variable>
#include <mutex>
#include <stdexcept>

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;

struct State {
  std::mutex mutex;
  std::condition_variable changed;
  int running = 0;
  bool ends = false;
};

// Never destroyed: see RunningCall.
State& TheState() {
  static auto& state = *new State;
  return state;
}

void WaitForRunningCalls() {
  State& state = TheState();
  const py::gil_scoped_release release;
  std::unique_lock lock(state.mutex);
  state.ends = true;
  while (state.running > 0) {
    state.changed.wait_for(lock, std::chrono::milliseconds(50));
    lock.unlock();  // or who holds the GIL could not end a call
    ThrowIfSignalRaised();
    lock.lock();
  }
}

}  // namespace

RunningCall::RunningCall() {
  State& state = TheState();
  const std::lock_guard lock(state.mutex);
  if (state.ends) throw std::runtime_error("the Python interpreter is about to end");
  ++state.running;
}

RunningCall::~RunningCall() {
  State& state = TheState();
  const std::lock_guard lock(state.mutex);
  --state.running;
  state.changed.notify_all();
}

void WaitForRunningCallsAtExit() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&WaitForRunningCalls));
}

void ThrowIfSignalRaised() {
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace gmapping_spa::python
