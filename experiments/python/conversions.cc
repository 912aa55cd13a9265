// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/python/conversions.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "backend/graph/graph_index.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;

// Fields of a structured type: name, format, and where the member lies in an instance.
class Layout {
 public:
  explicit Layout(const void* instance) : instance_(static_cast<const char*>(instance)) {}

  Layout& Field(const char* name, const char* format, const void* member) {
    names_.append(name);
    formats_.append(format);
    offsets_.append(static_cast<const char*>(member) - instance_);
    return *this;
  }

  py::dtype Dtype(std::size_t size) const {
    return {names_, formats_, offsets_, py::ssize_t(size)};
  }

 private:
  const char* instance_;
  py::list names_, formats_, offsets_;
};

[[noreturn]] void Fail(const char* what, const std::string& expected, const py::handle& found) {
  std::string type = py::str(py::type::of(found).attr("__name__"));
  if (py::isinstance<py::array>(found)) {
    type = "an array of shape " + std::string(py::str(found.attr("shape"))) + " and type " +
           std::string(py::str(found.attr("dtype")));
  }
  throw py::value_error(std::string(what) + ": expected " + expected + ", found " + type);
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Numbers, or nothing: what is complex, text or any object is none.
Numbers NumbersOf(const py::handle& value) {
  py::array array = py::array::ensure(value);
  if (!array || std::strchr("fiu", array.dtype().kind()) == nullptr) {
    PyErr_Clear();
    return py::reinterpret_steal<Numbers>(py::handle());
  }
  return Numbers::ensure(array);
}

template <typename T>
std::vector<T> ToElements(const py::handle& value, const char* what) {
  const py::dtype dtype = DtypeOf<T>();
  py::array array = py::array::ensure(value);
  if (!array) PyErr_Clear();
  const auto fail = [&] {
    Fail(what,
         "a one-dimensional array with the fields " + std::string(py::str(dtype.attr("names"))),
         array ? py::handle(array) : value);
  };
  if (!array || array.ndim() != 1) fail();
  if (!dtype.equal(array.dtype())) {
    // An array of the same fields in another layout, field by field.
    const py::object filled =
        py::module_::import("numpy").attr("zeros")(array.shape(0), py::arg("dtype") = dtype);
    for (const py::handle& name : dtype.attr("names")) {
      try {
        filled[name] = array[name];
      } catch (py::error_already_set&) {
        fail();
      }
    }
    array = filled;
  }
  std::vector<T> elements(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t k = 0; k < elements.size(); ++k) {
    std::memcpy(static_cast<void*>(&elements[k]), array.data(static_cast<py::ssize_t>(k)),
                sizeof(T));
  }
  return elements;
}

}  // namespace

template <>
py::dtype DtypeOf<backend::StampedPose>() {
  const backend::StampedPose pose;
  return Layout(&pose)
      .Field("stamp_s", "f8", &pose.stamp_s)
      .Field("world_T_robot", "(3,)f8", &pose.world_T_robot)
      .Dtype(sizeof(pose));
}

template <>
py::dtype DtypeOf<backend::Node>() {
  const backend::Node node;
  return Layout(&node)
      .Field("id", "i8", &node.id)
      .Field("stamp_s", "f8", &node.stamp_s)
      .Field("world_T_node", "(3,)f8", &node.world_T_node)
      .Field("fixed", "?", &node.fixed)
      .Dtype(sizeof(node));
}

template <>
py::dtype DtypeOf<backend::Edge>() {
  const backend::Edge edge;
  return Layout(&edge)
      .Field("i", "i8", &edge.i)
      .Field("j", "i8", &edge.j)
      .Field("i_T_j", "(3,)f8", &edge.i_T_j)
      .Field("information", "(3,3)f8", edge.information.data())
      .Field("kind", "u1", &edge.kind)
      .Dtype(sizeof(edge));
}

template <>
py::dtype DtypeOf<sensor::Beam>() {
  const sensor::Beam beam;
  return Layout(&beam)
      .Field("angle_rad", "f8", &beam.angle_rad)
      .Field("range_m", "f8", &beam.range_m)
      .Field("status", "u1", &beam.status)
      .Dtype(sizeof(beam));
}

py::array ToArray(const backend::SE2& pose) { return py::array_t<double>(3, &pose.x); }

backend::SE2 ToPose(const py::handle& value, const char* what) {
  const Numbers numbers = NumbersOf(value);
  constexpr char kExpected[] = "a pose of three finite numbers x, y, theta";
  if (!numbers || numbers.ndim() != 1 || numbers.size() != 3) Fail(what, kExpected, value);
  const backend::SE2 pose{numbers.at(0), numbers.at(1), numbers.at(2)};
  if (!pose.IsFinite()) {
    throw py::value_error(std::string(what) + ": expected " + kExpected + ", found " +
                          std::string(py::str(py::handle(numbers))));
  }
  return pose;
}

std::vector<backend::SE2> ToPoses(const py::handle& value, std::ptrdiff_t count, const char* what) {
  const Numbers numbers = NumbersOf(value);
  if (!numbers || numbers.ndim() != 2 || numbers.shape(1) != 3 ||
      (count >= 0 && numbers.shape(0) != count)) {
    Fail(what, "an array of poses of shape (" + (count < 0 ? "N" : std::to_string(count)) + ", 3)",
         numbers ? py::handle(numbers) : value);
  }
  std::vector<backend::SE2> poses(static_cast<std::size_t>(numbers.shape(0)));
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto row = static_cast<py::ssize_t>(k);
    poses[k] = {numbers.at(row, 0), numbers.at(row, 1), numbers.at(row, 2)};
    if (!poses[k].IsFinite()) {
      throw py::value_error(std::string(what) + ": expected finite numbers, found others in row " +
                            std::to_string(k));
    }
  }
  return poses;
}

template <>
std::vector<backend::StampedPose> ToVector(const py::handle& value, const char* what) {
  auto poses = ToElements<backend::StampedPose>(value, what);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (std::isfinite(poses[k].stamp_s) && poses[k].world_T_robot.IsFinite()) continue;
    throw py::value_error(std::string(what) + ": expected finite numbers, found others in row " +
                          std::to_string(k));
  }
  return poses;
}

template <>
std::vector<backend::Node> ToVector(const py::handle& value, const char* what) {
  auto nodes = ToElements<backend::Node>(value, what);
  for (backend::Node& node : nodes) {
    unsigned char byte = 0;  // a view of other bytes may hold any
    std::memcpy(&byte, &node.fixed, 1);
    node.fixed = byte != 0;
  }
  return nodes;
}

template <>
std::vector<backend::Edge> ToVector(const py::handle& value, const char* what) {
  return ToElements<backend::Edge>(value, what);
}

void CheckGraph(const backend::PoseGraph& graph) {
  for (const backend::Node& node : graph.nodes) {
    if (std::isfinite(node.stamp_s) && node.world_T_node.IsFinite()) continue;
    throw py::value_error("node " + std::to_string(node.id) +
                          ": expected a finite stamp and pose, found others");
  }
  for (const backend::Edge& edge : graph.edges) {
    const Eigen::Matrix3d& information = edge.information;
    const char* const wrong =
        !edge.i_T_j.IsFinite() || !information.allFinite() ? "finite numbers"
        : !information.isApprox(information.transpose(), 1e-9) &&
                (information - information.transpose()).cwiseAbs().maxCoeff() > 0.0
            ? "a symmetric information matrix"
        : static_cast<std::uint8_t>(edge.kind) >
                static_cast<std::uint8_t>(backend::EdgeKind::kLoopClosure)
            ? "a kind from 0 to 2"
            : nullptr;
    if (wrong == nullptr) continue;
    throw py::value_error("edge from node " + std::to_string(edge.i) + " to node " +
                          std::to_string(edge.j) + ": expected " + wrong + ", found others");
  }
  backend::IndexGraph(graph);
}

py::array ToArray(const std::vector<Eigen::Matrix3d>& matrices) {
  py::array_t<double> array({matrices.size(), std::size_t{3}, std::size_t{3}});
  auto values = array.mutable_unchecked<3>();
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        values(static_cast<py::ssize_t>(k), row, column) = matrices[k](row, column);
      }
    }
  }
  return array;
}

}  // namespace gmapping_spa::python
