// SPDX-License-Identifier: BSD-3-Clause
// Finished maps as arrays, and map_server's files.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "experiments/apps/output_files.h"
#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"
#include "frontend/map/map_server_io.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using map::CellState;
using map::TrinaryMap;

// Values of nav_msgs/OccupancyGrid.
constexpr std::int8_t kUnknown = -1, kFree = 0, kOccupied = 100;

py::array_t<std::int8_t> CellsOf(const TrinaryMap& map) {
  py::array_t<std::int8_t> cells({map.height, map.width});
  std::int8_t* const values = cells.mutable_data();
  for (std::size_t k = 0; k < map.cells.size(); ++k) {
    values[k] = map.cells[k] == CellState::kOccupied ? kOccupied
                : map.cells[k] == CellState::kFree   ? kFree
                                                     : kUnknown;
  }
  return cells;
}

TrinaryMap MakeMap(const py::object& cells, double resolution_m, double origin_x_m,
                   double origin_y_m) {
  const py::array given = py::array::ensure(cells);
  if (!given || given.ndim() != 2 || given.size() > map::kMaxMapCells ||
      (given.dtype().kind() != 'i' && given.dtype().kind() != 'u')) {
    PyErr_Clear();
    throw py::value_error("cells: expected a two-dimensional array of integers, " +
                          std::to_string(map::kMaxMapCells) + " at most");
  }
  if (!(resolution_m > 0.0) || !std::isfinite(resolution_m) || !std::isfinite(origin_x_m) ||
      !std::isfinite(origin_y_m)) {
    throw py::value_error("expected a finite resolution above 0 and a finite origin");
  }
  const auto values = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(given);
  TrinaryMap map;
  map.height = static_cast<int>(values.shape(0));
  map.width = static_cast<int>(values.shape(1));
  map.resolution_m = resolution_m;
  map.origin_x_m = origin_x_m;
  map.origin_y_m = origin_y_m;
  map.cells.resize(static_cast<std::size_t>(values.size()));
  for (std::size_t k = 0; k < map.cells.size(); ++k) {
    const std::int64_t value = values.data()[k];
    if (value != kUnknown && value != kFree && value != kOccupied) {
      throw py::value_error("cells: expected -1 (unknown), 0 (free) and 100 (occupied), found " +
                            std::to_string(value));
    }
    map.cells[k] = value == kOccupied ? CellState::kOccupied
                   : value == kFree   ? CellState::kFree
                                      : CellState::kUnknown;
  }
  return map;
}

void Write(const TrinaryMap& map, const std::filesystem::path& yaml_path) {
  if (yaml_path.extension() != ".yaml") {
    throw py::value_error(yaml_path.string() + ": expected a name that ends in .yaml");
  }
  if (map.cells.empty()) throw py::value_error("expected a map with cells, found an empty one");
  const std::filesystem::path name = yaml_path.filename();
  const std::string image = std::filesystem::path(name).replace_extension(".pgm").string();
  apps::OutputFiles files(yaml_path.has_parent_path() ? yaml_path.parent_path().string() : ".");
  files.Write(image, [&](std::ostream& out) { map::WritePgm(map, out); });
  files.Write(name.string(), [&](std::ostream& out) { map::WriteMapYaml(map, image, out); });
  files.Commit();
}

}  // namespace

void BindMap(py::module_& module) {
  py::class_<TrinaryMap>(module, "OccupancyMap",
                         "A finished map: every cell free, occupied or unknown. Row 0 is at the "
                         "bottom, where y is smallest.")
      .def(
          py::init(&MakeMap), py::arg("cells"), py::arg("resolution_m"),
          py::arg("origin_x_m") = 0.0, py::arg("origin_y_m") = 0.0,
          "cells: integers (height, width), -1 unknown, 0 free, 100 occupied. resolution_m: edge "
          "length of a cell. origin_x_m, origin_y_m: world coordinates of the lower left corner of "
          "cell (0, 0).\n\nRaises ValueError on other values and shapes.")
      .def("__repr__",
           [](const TrinaryMap& map) {
             return py::str("<OccupancyMap of {} x {} cells of {} m>")
                 .format(map.width, map.height, map.resolution_m);
           })
      .def_property_readonly("cells", &CellsOf,
                             "The cells, a new array (height, width) of int8 as in "
                             "nav_msgs/OccupancyGrid: -1 unknown, 0 free, 100 occupied.")
      .def_readonly("resolution_m", &TrinaryMap::resolution_m, "Edge length of a cell, m.")
      .def_readonly("origin_x_m", &TrinaryMap::origin_x_m,
                    "World coordinate x of the lower left corner, m.")
      .def_readonly("origin_y_m", &TrinaryMap::origin_y_m,
                    "World coordinate y of the lower left corner, m.")
      .def_property_readonly(
          "extent_m",
          [](const TrinaryMap& map) {
            return py::make_tuple(map.origin_x_m, map.origin_x_m + map.width * map.resolution_m,
                                  map.origin_y_m, map.origin_y_m + map.height * map.resolution_m);
          },
          "(x_min, x_max, y_min, y_max) in the world frame, m: what matplotlib's imshow takes as "
          "extent, with origin=\"lower\".")
      .def("write", &Write, py::arg("yaml_path"),
           "Writes the pair of ROS's map_server: this .yaml and the .pgm of the same name beside "
           "it. Both appear whole or not at all.");
  module.def(
      "read_map", [](const std::filesystem::path& path) { return map::ReadMap(path.string()); },
      py::arg("yaml_path"), py::call_guard<py::gil_scoped_release>(),
      "Reads a map of ROS's map_server (trinary mode; PGM, PPM or PNG).\n\nRaises RuntimeError "
      "\"file:line: expected ..., found ...\" where a key or the image is missing or broken.");
}

}  // namespace gmapping_spa::python
