// SPDX-License-Identifier: BSD-3-Clause
// A back end in a process of its own, which can be stopped, and whose end is not that of the
// program.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PROCESS_OPTIMIZER_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PROCESS_OPTIMIZER_H_

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

class WorkerProcess;

// Like LoadOptimizer, but the plugin is loaded by gmapping_spa_backend_worker, which lies beside
// the plugins of the build or installation. The process is there from the first call to the end of
// the optimizer, so that the back end may keep what it learned. A call that takes longer than
// `timeout_s` (wall time), and one in which the process crashes, exits or answers with what is no
// result, is a failed Summary that says so (CheckOptions: an exception); the poses are as they
// were, and the next call has a new process. What the back end returns is that of LoadOptimizer's
// to the bit.
class ProcessOptimizer : public Optimizer {
 public:
  // Throws std::runtime_error with one line like LoadOptimizer, also when the plugin crashes.
  ProcessOptimizer(const std::string& name, double timeout_s);
  ~ProcessOptimizer() override;

  void CheckOptions(const Options& options) const override;
  Summary Optimize(const Options& options, std::span<const Edge> edges,
                   std::span<Node> nodes) override;

 private:
  // Makes of what the channel throws an end of the process, and an exception that tells it.
  template <typename Function>
  void Watch(const Function& function) const;
  void Start(std::chrono::steady_clock::time_point deadline) const;
  // Sends the request and takes the nodes of the answer.
  Summary Call(const std::vector<char>& request, std::span<Node> nodes) const;

  std::string plugin_, worker_;  // paths
  double timeout_s_;
  mutable std::unique_ptr<WorkerProcess> process_;  // none: the next call makes one
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_PROCESS_OPTIMIZER_H_
