// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/python/python_optimizer.h"

#include <glog/logging.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize.h"
#include "backend/text.h"
#include "experiments/python/conversions.h"
#include "experiments/python/running_calls.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;

std::string LossesOf(const py::object& back_end) {
  std::string losses;
  if (!py::hasattr(back_end, "losses")) return losses;
  for (const py::handle& name : back_end.attr("losses")) {
    losses += std::string(py::str(name)) + ",";
  }
  return losses;
}

}  // namespace

PythonOptimizer::PythonOptimizer(py::object back_end)
    : back_end_(std::move(back_end)), raised_(py::none()) {
  if (!py::hasattr(back_end_, "optimize") || !PyCallable_Check(back_end_.attr("optimize").ptr())) {
    throw py::value_error(
        "backend: expected a name or an object with the method optimize(nodes, "
        "edges), found " +
        std::string(py::str(py::type::of(back_end_).attr("__name__"))));
  }
  losses_ = LossesOf(back_end_);
}

PythonOptimizer::~PythonOptimizer() {
  if (Py_IsInitialized() == 0) {  // there is nobody left to give the objects back to
    back_end_.release();
    raised_.release();
    return;
  }
  const py::gil_scoped_acquire acquire;
  back_end_ = py::object();
  raised_ = py::object();
}

void PythonOptimizer::CheckOptions(const backend::Options& options) const {
  const std::string loss = backend::LossKindName(options.loss.kind);
  if (!options.settings.empty()) {
    throw std::runtime_error("a back end in Python has no settings, found '" +
                             options.settings.begin()->first + "'");
  }
  if (options.loss.kind == backend::LossKind::kNone || losses_.find(loss + ",") == 0 ||
      losses_.find("," + loss + ",") != std::string::npos) {
    return;
  }
  throw std::runtime_error("the back end in Python does not support the loss " + loss +
                           ", its attribute losses has: " + (losses_.empty() ? "none" : losses_));
}

backend::Summary PythonOptimizer::Optimize(const backend::Options& options,
                                           std::span<const backend::Edge> edges,
                                           std::span<backend::Node> nodes) {
  const RunningCall running;
  const py::gil_scoped_acquire acquire;
  raised_ = py::none();
  try {
    return Call(options, edges, nodes);
  } catch (py::error_already_set& error) {
    raised_ = error.value();
    if (error.trace()) PyException_SetTraceback(raised_.ptr(), error.trace().ptr());
    const std::string type = py::str(error.type().attr("__name__"));
    const std::string text = py::str(error.value());
    // The exception itself must not leave: it is of Python, and who catches it has not the GIL.
    throw std::runtime_error(backend::Printable(type + (text.empty() ? "" : ": " + text)));
  } catch (const py::builtin_exception& error) {
    throw std::runtime_error(error.what());
  }
}

backend::Summary PythonOptimizer::Call(const backend::Options& options,
                                       std::span<const backend::Edge> edges,
                                       std::span<backend::Node> nodes) {
  const backend::GraphIndex index = backend::IndexGraph({nodes, edges});
  std::vector<backend::Node> shown(nodes.begin(), nodes.end());
  for (std::size_t k = 0; k < shown.size(); ++k) shown[k].fixed = index.fixed[k];
  // Arrays of their own: the back end may keep them.
  const py::array node_array = Copied(shown.data(), shown.size());
  const py::array edge_array = Copied(edges.data(), edges.size());
  py::dict keywords;
  if (!losses_.empty()) {
    keywords["loss"] = backend::LossKindName(options.loss.kind);
    keywords["loss_scale"] = options.loss.scale;
  }
  py::object result = back_end_.attr("optimize")(node_array, edge_array, **keywords);
  if (result.is_none()) result = node_array["world_T_node"];
  const std::vector<backend::SE2> poses =
      ToPoses(result, static_cast<std::ptrdiff_t>(nodes.size()), "optimize returned");

  backend::Summary summary;
  summary.initial_cost = backend::GraphCost({nodes, edges}, options.loss);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (index.fixed[k]) continue;
    nodes[k].world_T_node = poses[k];
    nodes[k].world_T_node.theta = backend::WrapAngle(poses[k].theta);
  }
  summary.final_cost = backend::GraphCost({nodes, edges}, options.loss);
  summary.termination = backend::Termination::kConverged;
  summary.message = "the back end in Python returned";
  return summary;
}

std::shared_ptr<backend::Optimizer> OptimizerFrom(const py::object& value) {
  if (py::isinstance<py::str>(value)) return backend::LoadOptimizer(value.cast<std::string>());
  return std::make_shared<PythonOptimizer>(value);
}

void FitLoss(const backend::Optimizer& optimizer, backend::Options* options) {
  try {
    backend::CheckOptions(*options, optimizer);
  } catch (const std::runtime_error&) {
    if (options->loss.kind != backend::LossKind::kMixture) throw;
    backend::Options plain = *options;
    plain.loss = {};
    optimizer.CheckOptions(plain);  // throws when it is not the loss
    LOG(WARNING) << "the back end does not support the loss dcs, which loss=\"mixture\" needs: "
                    "loss=\"none\"";
    *options = plain;
  }
}

}  // namespace gmapping_spa::python
