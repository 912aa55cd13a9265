// SPDX-License-Identifier: BSD-3-Clause
// How well the poses of a graph are known, and whether they are the global optimum.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "backend/certificate/staircase.h"
#include "backend/graph/graph_index.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/covariances.h"
#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"
#include "experiments/python/optimization.h"
#include "experiments/python/running_calls.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using backend::PoseGraph;

// Positions of the pairs of ids, (id, id) for a vector of single ones.
std::vector<backend::EdgeNodes> PairsOf(const PoseGraph& graph, const py::object& ids) {
  std::vector<backend::EdgeNodes> pairs;
  if (ids.is_none()) {
    for (int k = 0; k < static_cast<int>(graph.nodes.size()); ++k) pairs.push_back({k, k});
    return pairs;
  }
  const py::array given = py::array::ensure(ids);
  if (!given || (given.dtype().kind() != 'i' && given.dtype().kind() != 'u') || given.ndim() < 1 ||
      given.ndim() > 2 || (given.ndim() == 2 && given.shape(1) != 2)) {
    PyErr_Clear();
    throw py::value_error("ids: expected an array of ids (K,) or of pairs of ids (K, 2)");
  }
  const auto numbers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(given);
  std::unordered_map<std::int64_t, int> positions;
  for (const backend::Node& node : graph.nodes) {
    positions.emplace(node.id, static_cast<int>(positions.size()));
  }
  const auto position_of = [&](std::int64_t id) {
    const auto found = positions.find(id);
    if (found != positions.end()) return found->second;
    throw py::value_error("ids: there is no node " + std::to_string(id));
  };
  const std::int64_t* const values = numbers.data();
  for (py::ssize_t k = 0; k < numbers.shape(0); ++k) {
    const std::int64_t i = numbers.ndim() == 1 ? values[k] : values[2 * k];
    const std::int64_t j = numbers.ndim() == 1 ? values[k] : values[2 * k + 1];
    pairs.push_back({position_of(i), position_of(j)});
  }
  return pairs;
}

py::array Covariances(const PoseGraph& graph, const py::object& ids,
                      const std::optional<Optimization>& summary) {
  CheckGraph(graph);
  PoseGraph weighted = graph;
  if (summary) {
    if (summary->summary.edge_weights.size() != graph.edges.size()) {
      throw py::value_error("summary: expected that of this graph, found one of " +
                            std::to_string(summary->summary.edge_weights.size()) + " edges for " +
                            std::to_string(graph.edges.size()));
    }
    weighted.edges = backend::EdgesOfResult(summary->loss, graph.edges, summary->summary);
  }
  return ToArray(
      CallInterruptibly([graph = std::move(weighted), pairs = PairsOf(graph, ids),
                         spa = std::shared_ptr<backend::Optimizer>(backend::LoadOptimizer("spa"))] {
        return backend::Covariances(graph, pairs, spa.get());
      }));
}

std::pair<PoseGraph, backend::StaircaseResult> Certify(const PoseGraph& graph, bool descend) {
  CheckGraph(graph);
  return CallInterruptibly(
      [copy = graph, descend,
       spa = std::shared_ptr<backend::Optimizer>(backend::LoadOptimizer("spa"))]() mutable {
        backend::StaircaseOptions options;
        options.descend = descend;
        backend::StaircaseResult result = backend::ClimbStaircase(options, spa.get(), &copy);
        return std::pair(std::move(copy), std::move(result));
      });
}

}  // namespace

void BindAccuracy(py::module_& module) {
  using backend::StaircaseResult;
  module.def(
      "covariances", &Covariances, py::arg("graph"), py::arg("ids") = py::none(),
      py::arg("summary") = py::none(),
      "Covariances of the poses (x, y, theta) of nodes, an array (K, 3, 3) in m and rad; x "
      "and y along the axes of the world frame.\n\nids: of all nodes (None), of these (K,), "
      "or between the poses of pairs (K, 2), rows the first. summary: that of the "
      "optimization of this graph, whose rejected edges count for nothing then.\n\nThey are "
      "those of least squares to first order at the poses of the graph, from the "
      "information of the edges, relative to what is held: fixed nodes, or the first node of "
      "a component without one. Raises RuntimeError when the edges do not determine all "
      "poses.");
  py::class_<StaircaseResult>(module, "Certificate",
                              "Whether poses are the global optimum of least squares, all edges at "
                              "their information.")
      .def_property_readonly(
          "optimal", [](const StaircaseResult& r) { return r.certificate.optimal(); },
          "Whether no other poses cost less, but for a millionth of the cost.")
      .def_property_readonly(
          "cost", [](const StaircaseResult& r) { return r.certificate.cost; },
          "Half the sum of the squared errors at the poses.")
      .def_property_readonly(
          "lower_bound", [](const StaircaseResult& r) { return r.certificate.lower_bound; },
          "No poses cost less.")
      .def_property_readonly(
          "relative_gap", [](const StaircaseResult& r) { return r.certificate.relative_gap; },
          "The poses are the optimum but for this part of the cost, 0 to 1.")
      .def("__repr__", [](const StaircaseResult& r) {
        return py::str("<Certificate: {}, cost {}, lower bound {}>")
            .format(r.certificate.optimal() ? "optimal" : "not proved", r.certificate.cost,
                    r.certificate.lower_bound);
      });
  module.def(
      "certify", &Certify, py::arg("graph"), py::kw_only(), py::arg("descend") = false,
      "Proves that the poses of the graph are the global optimum of least squares, or tells "
      "how far they may be off; returns a graph and a Certificate. descend: leave poses that "
      "are not proved to be optimal for better ones (Riemannian staircase).");
}

}  // namespace gmapping_spa::python
