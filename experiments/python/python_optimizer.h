// SPDX-License-Identifier: BSD-3-Clause
// A back end written in Python.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_PYTHON_OPTIMIZER_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_PYTHON_OPTIMIZER_H_

#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::python {

// Calls the method `optimize(nodes, edges)` of an object, from any thread. An object with the
// attribute `losses`, names of robust losses, gets `loss` and `loss_scale` as well.
class PythonOptimizer : public backend::Optimizer {
 public:
  // Throws pybind11::value_error when it has no such method. Holds the GIL.
  explicit PythonOptimizer(pybind11::object back_end);
  ~PythonOptimizer() override;

  void CheckOptions(const backend::Options& options) const override;
  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge> edges,
                            std::span<backend::Node> nodes) override;

  // What the last call raised, or None. Holds the GIL.
  const pybind11::object& raised() const { return raised_; }

 private:
  backend::Summary Call(const backend::Options& options, std::span<const backend::Edge> edges,
                        std::span<backend::Node> nodes);

  pybind11::object back_end_;
  pybind11::object raised_;
  std::string losses_;  // names between commas
};

// The back end that `value` is: the name or path of a plugin, or an object with the method
// `optimize`. Throws std::runtime_error where there is none of that name.
std::shared_ptr<backend::Optimizer> OptimizerFrom(const pybind11::object& value);

// The mixture, which is the default loss, needs the loss dcs: where the back end has not, the loss
// becomes none, and a warning says so. Throws std::runtime_error where the optimizer cannot do what
// else the options ask for.
void FitLoss(const backend::Optimizer& optimizer, backend::Options* options);

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_PYTHON_OPTIMIZER_H_
