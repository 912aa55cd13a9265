// SPDX-License-Identifier: BSD-3-Clause
// Optimizing pose graphs with any back end.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "backend/initialization/initialization.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize.h"
#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"
#include "experiments/python/log_messages.h"
#include "experiments/python/optimization.h"
#include "experiments/python/python_optimizer.h"
#include "experiments/python/running_calls.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using backend::PoseGraph;

// Raises what a back end in Python raised, or an error whose cause that is.
[[noreturn]] void RaiseFailure(const std::string& message, backend::Optimizer* optimizer) {
  const auto* const own = dynamic_cast<PythonOptimizer*>(optimizer);
  if (own == nullptr || own->raised().is_none()) throw std::runtime_error(message);
  const py::object raised = own->raised();
  if (!PyErr_GivenExceptionMatches(raised.ptr(), PyExc_Exception)) {  // KeyboardInterrupt
    PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
    throw py::error_already_set();
  }
  PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
  py::raise_from(PyExc_RuntimeError, message.c_str());
  throw py::error_already_set();
}

using Optimized = std::pair<PoseGraph, Optimization>;

Optimized OptimizeCopy(backend::Options options, bool gnc, backend::Optimizer* optimizer,
                       PoseGraph graph) {
  backend::Summary summary = backend::Optimize(options, gnc, optimizer, &graph);
  return {std::move(graph), {options.loss, std::move(summary)}};
}

Optimized Optimize(const PoseGraph& graph, const py::object& back_end, const std::string& loss,
                   double loss_scale, bool gnc, const std::string& init, int max_iterations,
                   double cost_tolerance, double max_solver_time_s,
                   const std::map<std::string, std::string>& settings) {
  CheckGraph(graph);
  backend::Options options;
  try {
    options.loss = {backend::LossKindFromName(loss), loss_scale};
    options.initialization = backend::InitializationFromName(init);
  } catch (const std::runtime_error& error) {
    throw py::value_error(error.what());
  }
  if (!(loss_scale > 0.0) || !std::isfinite(loss_scale) || max_iterations < 0 ||
      !(cost_tolerance >= 0.0) || !(max_solver_time_s > 0.0)) {
    throw py::value_error(
        "expected a finite loss_scale above 0, max_iterations and cost_tolerance from 0, "
        "max_solver_time_s above 0");
  }
  options.max_iterations = max_iterations;
  options.cost_tolerance = cost_tolerance;
  options.max_solver_time_s = max_solver_time_s;
  options.settings = settings;
  const std::shared_ptr<backend::Optimizer> optimizer = OptimizerFrom(back_end);
  FitLoss(*optimizer, &options);

  Optimized optimized;
  if (dynamic_cast<PythonOptimizer*>(optimizer.get()) != nullptr) {
    // In this thread, where Ctrl-C reaches it.
    const py::gil_scoped_release release;
    optimized = OptimizeCopy(options, gnc, optimizer.get(), graph);
  } else {
    optimized = CallInterruptibly([options, gnc, optimizer, graph]() mutable {
      return OptimizeCopy(options, gnc, optimizer.get(), std::move(graph));
    });
  }
  HandOnLogMessages();
  const backend::Summary& summary = optimized.second.summary;
  if (summary.termination == backend::Termination::kFailure) {
    RaiseFailure("the back end failed: " + summary.message, optimizer.get());
  }
  return optimized;
}

py::list ListBackends() {
  py::list list;
  for (const auto& found : backend::ListBackends(backend::PluginSearchPath())) {
    py::dict settings;
    for (const auto& setting : found.settings) {
      settings[setting.name] = std::string(setting.help) + " (" + backend::RangeOf(setting) +
                               ", default " + setting.default_value + ")";
    }
    py::dict entry;
    entry["name"] = found.name;
    entry["path"] = found.path;
    entry["description"] = found.description;
    entry["loadable"] = found.loadable;
    entry["losses"] = found.losses;
    entry["settings"] = settings;
    list.append(entry);
  }
  return list;
}

}  // namespace

void BindOptimize(py::module_& module) {
  py::class_<Optimization>(module, "Summary", "What became of an optimization.")
      .def_property_readonly(
          "converged",
          [](const Optimization& o) {
            return o.summary.termination == backend::Termination::kConverged;
          },
          "False: it ran out of iterations or of time.")
      .def_property_readonly(
          "message", [](const Optimization& o) { return o.summary.message; },
          "One line, why it ended.")
      .def_property_readonly(
          "initial_cost", [](const Optimization& o) { return o.summary.initial_cost; },
          "Cost of the poses that were given: half the sum of the (robust) squared errors.")
      .def_property_readonly(
          "final_cost", [](const Optimization& o) { return o.summary.final_cost; },
          "Cost of the poses that are returned.")
      .def_property_readonly(
          "iterations", [](const Optimization& o) { return o.summary.iterations.size(); },
          "Number of iterations that the back end tells of.")
      .def_property_readonly(
          "edge_weights",
          [](const Optimization& o) {
            return py::array_t<double>(static_cast<py::ssize_t>(o.summary.edge_weights.size()),
                                       o.summary.edge_weights.data());
          },
          "For each edge the inlier probability under the loss mixture, else the weight that the "
          "loss gives it; below 0.5 the edge is rejected.")
      .def("__repr__", [](const Optimization& o) {
        return py::str("<Summary: cost {} to {}, {}>")
            .format(o.summary.initial_cost, o.summary.final_cost, o.summary.message);
      });
  const backend::Options defaults;
  module.def(
      "optimize", &Optimize, py::arg("graph"), py::arg("backend") = "spa", py::kw_only(),
      py::arg("loss") = "mixture", py::arg("loss_scale") = 3.0, py::arg("gnc") = true,
      py::arg("init") = "auto", py::arg("max_iterations") = defaults.max_iterations,
      py::arg("cost_tolerance") = defaults.cost_tolerance,
      py::arg("max_solver_time_s") = defaults.max_solver_time_s,
      py::arg("settings") = std::map<std::string, std::string>(),
      "Optimizes a pose graph; returns a new one and a Summary. `graph` stays as it "
      "is.\n\nbackend: "
      "spa, ceres, none, the path of a plugin, or an object with the method optimize(nodes, "
      "edges), "
      "which gets arrays of NODE_DTYPE and EDGE_DTYPE and returns the poses (N, 3), x, y in m and "
      "theta in rad, or None when it changed nodes[\"world_T_node\"]. Nodes that are `fixed` stay "
      "where they are.\n\nThe keywords are the flags of optimize_graph of the same names; settings "
      "are a back end's own (list_backends). Ctrl-C raises KeyboardInterrupt; a plugin works on to "
      "the end of its call, and its result is dropped.\n\nRaises ValueError on a graph or an "
      "option "
      "that is none, RuntimeError with one line when there is no such back end, when it cannot do "
      "what is asked for, or when it fails; the exception of a back end in Python is its cause.");
  module.def("list_backends", &ListBackends,
             "The back ends that are found by name: dicts with name, path, description, loadable, "
             "losses and settings (name: help).");
}

}  // namespace gmapping_spa::python
