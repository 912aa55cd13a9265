// SPDX-License-Identifier: BSD-3-Clause
// The module gmapping_spa._core, which the package gmapping_spa hands on.
#include <pybind11/pybind11.h>

#include "experiments/apps/freed_memory.h"
#include "experiments/python/bindings.h"
#include "experiments/python/log_messages.h"
#include "experiments/python/running_calls.h"

PYBIND11_MODULE(_core, module) {
  using namespace gmapping_spa::python;  // NOLINT: a macro opens the function
  module.doc() = "2D lidar SLAM with interchangeable pose-graph back ends.";
  module.attr("__version__") = GMAPPING_SPA_VERSION;
  gmapping_spa::apps::KeepFreedMemory();
  CollectLogMessages();
  WaitForRunningCallsAtExit();
  BindFiles(module);
  BindScan(module);
  BindMap(module);
  BindGraph(module);
  BindOptimize(module);
  BindAccuracy(module);
  BindSlamOptions(module);
  BindSlam(module);
  BindMetrics(module);
  BindSimulation(module);
}
