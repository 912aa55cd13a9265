// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/python/files.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include <stdexcept>

#include "experiments/apps/input_file.h"
#include "experiments/apps/output_files.h"
#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;

py::array ReadTum(const std::filesystem::path& path) {
  const backend::Trajectory trajectory =
      backend::ReadTum(*apps::OpenInput(path.string()), path.string());
  return Copied(trajectory.data(), trajectory.size());
}

void WriteTum(const std::filesystem::path& path, const py::object& trajectory) {
  const auto poses = ToVector<backend::StampedPose>(trajectory, "trajectory");
  WriteFile(path, [&](std::ostream& out) { backend::WriteTum(poses, out); });
}

}  // namespace

void WriteFile(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  if (!path.has_filename()) {
    throw std::runtime_error(path.string() + ": expected the name of a file");
  }
  apps::OutputFiles files(path.has_parent_path() ? path.parent_path().string() : ".");
  files.Write(path.filename().string(), write);
  files.Commit();
}

void BindFiles(py::module_& module) {
  module.attr("TRAJECTORY_DTYPE") = DtypeOf<backend::StampedPose>();
  module.def(
      "read_tum", &ReadTum, py::arg("path"),
      "Reads a trajectory in the TUM format, plain or gzipped: \"stamp x y z qx qy qz qw\" a "
      "line.\n\nReturns a structured array of TRAJECTORY_DTYPE: stamp_s in s, world_T_robot "
      "(3,) = x, y in m and theta in rad.\n\nRaises RuntimeError \"file:line: expected ..., "
      "found ...\" on a malformed file.");
  module.def("write_tum", &WriteTum, py::arg("path"), py::arg("trajectory"),
             "Writes a trajectory (array of TRAJECTORY_DTYPE) in the TUM format, with as many "
             "digits as it takes to read back the same values. The file appears whole or not at "
             "all.\n\nRaises ValueError on numbers that are not finite.");
}

}  // namespace gmapping_spa::python
