// SPDX-License-Identifier: BSD-3-Clause
// Pose graphs as structured arrays, and .g2o files.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include <glog/logging.h>

#include "backend/graph/g2o_io.h"
#include "experiments/apps/input_file.h"
#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"
#include "experiments/python/files.h"
#include "experiments/python/log_messages.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using backend::PoseGraph;

PoseGraph MakeGraph(const py::object& nodes, const py::object& edges) {
  PoseGraph graph{ToVector<backend::Node>(nodes, "nodes"), ToVector<backend::Edge>(edges, "edges")};
  CheckGraph(graph);
  return graph;
}

PoseGraph ReadG2o(const std::filesystem::path& path, bool strict) {
  backend::G2oRemarks remarks;
  PoseGraph graph = [&] {
    const py::gil_scoped_release release;
    return backend::ReadG2o(*apps::OpenInput(path.string()), path.string(), {.strict = strict},
                            &remarks);
  }();
  for (const auto& [remark, count] : remarks) {
    LOG(WARNING) << path.string() << ": " << remark << " (" << count << ")";
  }
  HandOnLogMessages();
  return graph;
}

void WriteG2o(const std::filesystem::path& path, const PoseGraph& graph) {
  CheckGraph(graph);
  WriteFile(path, [&](std::ostream& out) { backend::WriteG2o(graph, out); });
}

}  // namespace

void BindGraph(py::module_& module) {
  module.attr("NODE_DTYPE") = DtypeOf<backend::Node>();
  module.attr("EDGE_DTYPE") = DtypeOf<backend::Edge>();
  py::class_<PoseGraph>(
      module, "PoseGraph",
      "Robot poses and what was measured between them. Its arrays are views that can be written "
      "to; what uses a graph checks it first.")
      .def(
          py::init(&MakeGraph), py::arg("nodes"), py::arg("edges"),
          "nodes: structured array of NODE_DTYPE. edges: of EDGE_DTYPE. Both are copied.\n\nRaises "
          "ValueError where a field is missing, a number is not finite, an information matrix is "
          "not symmetric, or an edge names a node that does not exist.")
      .def("__repr__",
           [](const PoseGraph& graph) {
             return py::str("<PoseGraph of {} nodes and {} edges>")
                 .format(graph.nodes.size(), graph.edges.size());
           })
      .def_property_readonly(
          "nodes",
          [](const py::object& self) {
            return View(self.cast<const PoseGraph&>().nodes, self, true);
          },
          "View of the nodes: id, stamp_s in s, world_T_node (3,) = x, y in m and theta in rad in "
          "the world frame, fixed (no back end moves it).")
      .def_property_readonly(
          "edges",
          [](const py::object& self) {
            return View(self.cast<const PoseGraph&>().edges, self, true);
          },
          "View of the edges: ids i and j, i_T_j (3,) = the measured pose of j in the frame of i, "
          "m "
          "and rad, information (3, 3) = inverse covariance of (x, y, theta) in the frame of i, "
          "kind (EdgeKind).")
      .def(
          "copy", [](const PoseGraph& graph) { return graph; }, "A graph of its own.");
  module.def("read_g2o", &ReadG2o, py::arg("path"), py::kw_only(), py::arg("strict") = false,
             "Reads a pose graph, .g2o or TORO's .graph, plain or gzipped.\n\nWhat is left out or "
             "taken for something else is counted and said to the logger gmapping_spa; strict "
             "refuses it. Raises RuntimeError \"file:line: expected ..., found ...\" on malformed "
             "records.");
  module.def(
      "write_g2o", &WriteG2o, py::arg("path"), py::arg("graph"),
      "Writes a pose graph as .g2o, with as many digits as it takes to read back the same "
      "values. Stamps and kinds of edges have no place in the format. The file appears whole "
      "or not at all.");
}

}  // namespace gmapping_spa::python
