// SPDX-License-Identifier: BSD-3-Clause
// Laser scans from arrays, and from logs.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "experiments/apps/input_file.h"
#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"
#include "experiments/python/log_messages.h"
#include "experiments/python/ranges.h"
#include "frontend/sensor/beams.h"
#include "frontend/sensor/open_log.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using sensor::LaserScan;

double Finite(double value, const char* what) {
  if (std::isfinite(value)) return value;
  throw py::value_error(std::string(what) + ": expected a finite number, found " +
                        std::string(py::str(py::float_(value))));
}

backend::SE2 Mounting(const py::object& robot_T_laser) {
  constexpr double kFarthest_m = 100.0;
  const backend::SE2 pose = ToPose(robot_T_laser, "robot_T_laser");
  if (pose.translation().norm() <= kFarthest_m) return pose;
  throw py::value_error("robot_T_laser: expected a laser within 100 m of the robot");
}

LaserScan MakeScan(double stamp_s, const py::object& ranges_m, std::optional<double> angle_min_rad,
                   std::optional<double> angle_step_rad, const py::object& odom_T_robot,
                   const py::object& robot_T_laser, double range_min_m, double usable_range_m) {
  LaserScan scan;
  scan.stamp_s = Finite(stamp_s, "stamp_s");
  scan.has_odometry = !odom_T_robot.is_none();
  if (scan.has_odometry) scan.odom_T_robot = ToPose(odom_T_robot, "odom_T_robot");
  scan.odom_T_robot.theta = backend::WrapAngle(scan.odom_T_robot.theta);
  scan.robot_T_laser = Mounting(robot_T_laser);
  if (angle_min_rad.has_value() != angle_step_rad.has_value()) {
    throw py::value_error("expected both angle_min_rad and angle_step_rad, or none of them");
  }
  if (!(range_min_m >= 0.0 && usable_range_m > range_min_m && usable_range_m <= 1e4)) {
    throw py::value_error("expected 0 <= range_min_m < usable_range_m <= 10000");
  }
  const RangesView ranges(ranges_m);
  sensor::BeamAngles angles = sensor::TabulatedAngles(ranges.size());
  if (angle_min_rad) {
    angles = {Finite(*angle_min_rad, "angle_min_rad"), Finite(*angle_step_rad, "angle_step_rad")};
  }
  if (std::abs(angles.first_rad) + std::abs(angles.step_rad) * static_cast<double>(ranges.size()) >
      1e6) {
    throw py::value_error("expected beam angles within 1e6 rad of 0");
  }
  ranges.Visit([&](auto range_of) {
    scan.beams.reserve(ranges.size());
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      scan.beams.push_back(sensor::MakeBeam(angles, k, static_cast<double>(range_of(k)),
                                            range_min_m, usable_range_m));
    }
  });
  return scan;
}

class CarmenLog {
 public:
  CarmenLog(const std::filesystem::path& path, const sensor::LogOptions& options)
      : reader_(sensor::OpenCarmenLog(apps::OpenInput(path.string()), path.string(), options)) {}

  LaserScan Next() {
    std::optional<LaserScan> scan = reader_->Next();
    HandOnLogMessages();
    if (!scan) throw py::stop_iteration();
    return std::move(*scan);
  }
  sensor::LogCounts counts() const { return reader_->counts(); }

 private:
  std::unique_ptr<sensor::LogReader> reader_;
};

void BindLog(py::module_& module) {
  py::class_<CarmenLog>(
      module, "CarmenLog",
      "The scans of a CARMEN log, plain or gzipped, in the order of their time stamps: an iterator "
      "of LaserScan.\n\nScans are those of the executable gmapping_spa with the same flags. Raises "
      "RuntimeError \"file:line: expected ..., found ...\" on bad input.")
      .def(py::init([](const std::filesystem::path& path, double usable_range_m, double range_min_m,
                       std::optional<double> fov_rad, std::optional<double> angle_min_rad,
                       const py::object& robot_T_laser, bool flipped, bool strict) {
             sensor::LogOptions options;
             options.usable_range_m = usable_range_m;
             options.range_min_m = range_min_m;
             options.fov_rad = fov_rad;
             options.angle_min_rad = angle_min_rad;
             if (!robot_T_laser.is_none()) options.robot_T_laser = Mounting(robot_T_laser);
             options.flipped = flipped;
             if (strict) options.bad_record = sensor::BadRecordPolicy::kFail;
             return std::make_unique<CarmenLog>(path, options);
           }),
           py::arg("path"), py::kw_only(),
           py::arg("usable_range_m") = sensor::LogOptions().usable_range_m,
           py::arg("range_min_m") = sensor::LogOptions().range_min_m,
           py::arg("fov_rad") = py::none(), py::arg("angle_min_rad") = py::none(),
           py::arg("robot_T_laser") = py::none(), py::arg("flipped") = false,
           py::arg("strict") = false,
           "usable_range_m: a reading this long or longer is no return, m. range_min_m: a shorter "
           "one is invalid, m. fov_rad, angle_min_rad, robot_T_laser: override what the log says. "
           "flipped: mounted upside down. strict: stop at a record that cannot be taken as it "
           "stands, instead of counting it.")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &CarmenLog::Next)
      .def_property_readonly("counts", &CarmenLog::counts,
                             "What has been read so far, by name: scans, unknown_records, ...");
}

}  // namespace

void BindScan(py::module_& module) {
  const sensor::LogOptions defaults;
  module.attr("BEAM_DTYPE") = DtypeOf<sensor::Beam>();
  py::class_<LaserScan>(
      module, "LaserScan",
      "One sweep of a planar range finder, with the odometry that belongs to it. Immutable.")
      .def(
          py::init(&MakeScan), py::arg("stamp_s"), py::arg("ranges_m"), py::kw_only(),
          py::arg("angle_min_rad") = py::none(), py::arg("angle_step_rad") = py::none(),
          py::arg("odom_T_robot") = py::none(),
          py::arg("robot_T_laser") = py::make_tuple(0.0, 0.0, 0.0),
          py::arg("range_min_m") = defaults.range_min_m,
          py::arg("usable_range_m") = defaults.usable_range_m,
          "stamp_s: time of measurement, s. ranges_m: array (N,) of ranges in m, in the order of "
          "measurement; float32 and float64 are read where they lie, of any stride, other types of "
          "numbers are converted to float64 first. nan, a negative range and one below range_min_m "
          "are invalid; usable_range_m or more, and infinity, are no return.\n\nBeam i points to "
          "angle_min_rad + i * angle_step_rad, counter-clockwise from the laser's x axis; without "
          "both: 180 degrees, as CARMEN has them. odom_T_robot: raw odometry (x, y, theta) in m "
          "and rad at that time; None: there is none. robot_T_laser: the mounting.\n\nRaises "
          "ValueError on other shapes and on numbers that are not finite.")
      .def("__len__", [](const LaserScan& scan) { return scan.beams.size(); })
      .def("__repr__",
           [](const LaserScan& scan) {
             return py::str("<LaserScan of {} beams at {} s>")
                 .format(scan.beams.size(), scan.stamp_s);
           })
      .def_readonly("index", &LaserScan::index,
                    "Position among the scans of its log, whose lines need not be in the order of "
                    "time; 0 for a scan from an array.")
      .def_readonly("stamp_s", &LaserScan::stamp_s, "Time of measurement, s.")
      .def_property_readonly(
          "odom_T_robot",
          [](const LaserScan& scan) -> py::object {
            if (!scan.has_odometry) return py::none();
            return ToArray(scan.odom_T_robot);
          },
          "Raw odometry [x, y, theta] in m and rad, or None.")
      .def_property_readonly(
          "robot_T_laser", [](const LaserScan& scan) { return ToArray(scan.robot_T_laser); },
          "Mounting of the laser [x, y, theta] in the frame of the robot, m and rad.")
      .def_property_readonly(
          "beams",
          [](const py::object& self) {
            return View(self.cast<const LaserScan&>().beams, self, false);
          },
          "The beams, a read-only view of BEAM_DTYPE: angle_rad in the frame of the laser, range_m "
          "(the usable range for no return, 0 for invalid), status (BeamStatus).");
  BindLog(module);
}

}  // namespace gmapping_spa::python
