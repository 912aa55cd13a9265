// SPDX-License-Identifier: BSD-3-Clause
// Poses, trajectories and parts of graphs as arrays, and back.
#ifndef GMAPPING_SPA_EXPERIMENTS_PYTHON_CONVERSIONS_H_
#define GMAPPING_SPA_EXPERIMENTS_PYTHON_CONVERSIONS_H_

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::python {

// The layout of a C++ type as a structured type of numpy, so that arrays are views.
template <typename T>
pybind11::dtype DtypeOf();
template <>
pybind11::dtype DtypeOf<backend::StampedPose>();
template <>
pybind11::dtype DtypeOf<backend::Node>();
template <>
pybind11::dtype DtypeOf<backend::Edge>();
template <>
pybind11::dtype DtypeOf<sensor::Beam>();

// [x, y, theta]
pybind11::array ToArray(const backend::SE2& pose);

// Three finite numbers. Throws pybind11::value_error "<what>: expected ..., found ...".
backend::SE2 ToPose(const pybind11::handle& value, const char* what);

// An array of shape (count, 3) with finite numbers, count < 0: of any length.
std::vector<backend::SE2> ToPoses(const pybind11::handle& value, std::ptrdiff_t count,
                                  const char* what);

// A view of elements that `owner` keeps.
template <typename T>
pybind11::array View(const std::vector<T>& elements, const pybind11::handle& owner,
                     bool writeable) {
  pybind11::array array(DtypeOf<T>(), {elements.size()}, {sizeof(T)}, elements.data(), owner);
  if (!writeable) array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

// An array of its own.
template <typename T>
pybind11::array Copied(const T* elements, std::size_t count) {
  return pybind11::array(DtypeOf<T>(), {count}, {sizeof(T)}, elements);
}

// The elements of a structured array, or of what numpy makes one of the same fields of. Throws
// pybind11::value_error "<what>: ..." where a field is missing or the array has not one dimension.
template <typename T>
std::vector<T> ToVector(const pybind11::handle& value, const char* what);
template <>
std::vector<backend::StampedPose> ToVector(const pybind11::handle& value, const char* what);
template <>
std::vector<backend::Node> ToVector(const pybind11::handle& value, const char* what);
template <>
std::vector<backend::Edge> ToVector(const pybind11::handle& value, const char* what);

// Throws pybind11::value_error where a graph from Python is none: numbers that are not finite,
// information that is not symmetric, edges of unknown nodes or kinds, a node twice.
void CheckGraph(const backend::PoseGraph& graph);

// As an array of shape (count, 3, 3).
pybind11::array ToArray(const std::vector<Eigen::Matrix3d>& matrices);

}  // namespace gmapping_spa::python

#endif  // GMAPPING_SPA_EXPERIMENTS_PYTHON_CONVERSIONS_H_
