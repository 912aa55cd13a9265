// SPDX-License-Identifier: BSD-3-Clause
// A simulated robot: its scans, and the truth.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"
#include "experiments/python/running_calls.h"
#include "experiments/simulation/scan_player.h"
#include "experiments/simulation/simulation.h"
#include "experiments/simulation/truth_map.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;
using simulation::SimulationOptions, simulation::WayPoints;

struct Run {
  std::vector<sensor::LaserScan> scans;
  simulation::SimulationSummary summary;
  map::TrinaryMap truth_map;
};

// Collects scans, and lets Ctrl-C through.
class Collector : public simulation::ScanPlayer {
 public:
  explicit Collector(std::vector<sensor::LaserScan>* scans)
      : ScanPlayer([scans](const sensor::LaserScan& scan) { scans->push_back(scan); }) {}

  void OnOdometry(const simulation::OdometryReading& reading) override {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_look_ > std::chrono::milliseconds(50)) {
      last_look_ = now;
      ThrowIfSignalRaised();
    }
    ScanPlayer::OnOdometry(reading);
  }

 private:
  std::chrono::steady_clock::time_point last_look_ = std::chrono::steady_clock::now();
};

simulation::Scene SceneOf(const py::object& world) {
  if (!py::isinstance<map::TrinaryMap>(world)) {
    std::filesystem::path path;
    try {
      path = world.cast<std::filesystem::path>();
    } catch (const py::cast_error&) {
      throw py::type_error("world: expected an OccupancyMap or a path");
    }
    return simulation::Scene::Read(path.string(), "", false);
  }
  const auto& raster = world.cast<const map::TrinaryMap&>();
  if (raster.cells.empty()) throw py::value_error("world: expected a map with cells");
  return simulation::Scene(simulation::World(raster));
}

WayPoints WayPointsOf(const py::object& way_points) {
  const auto given =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(way_points);
  if (!given || given.ndim() != 2 || given.shape(1) != 2 || given.shape(0) < 2) {
    PyErr_Clear();
    throw py::value_error("way_points: expected an array (N, 2) of two or more positions");
  }
  WayPoints points;
  for (py::ssize_t k = 0; k < given.shape(0); ++k) {
    points.emplace_back(given.at(k, 0), given.at(k, 1));
    if (!points.back().allFinite() || (k > 0 && points[k - 1] == points.back())) {
      throw py::value_error("way_points: expected finite positions, no two neighbors the same");
    }
  }
  return points;
}

double InRange(const char* what, double value, double min, double max) {
  if (value >= min && value <= max) return value;
  throw py::value_error(std::string(what) + ": expected a number from " +
                        std::string(py::str(py::float_(min))) + " to " +
                        std::string(py::str(py::float_(max))) + ", found " +
                        std::string(py::str(py::float_(value))));
}

Run Simulate(const py::object& world, const py::object& way_points, std::uint64_t seed, int beams,
             double fov_rad, double scan_rate_hz, double max_range_m, double range_noise_m,
             const py::object& robot_T_laser, double max_speed_m_s, double robot_radius_m,
             double odometry_noise, double interference) {
  SimulationOptions options;
  options.seed = seed;
  options.lidar.beams = static_cast<int>(InRange("beams", beams, 1, 100000));
  options.lidar.fov_rad = InRange("fov_rad", fov_rad, 0.0, 2.0 * std::numbers::pi);
  options.lidar.rate_hz = InRange("scan_rate_hz", scan_rate_hz, 0.1, 1000.0);
  options.lidar.max_range_m = InRange("max_range_m", max_range_m, 0.01, 10000.0);
  options.lidar.range_noise_m = InRange("range_noise_m", range_noise_m, 0.0, 100.0);
  options.lidar.robot_T_laser = ToPose(robot_T_laser, "robot_T_laser");
  options.follower.max_speed_m_s = InRange("max_speed_m_s", max_speed_m_s, 0.01, 100.0);
  options.robot_radius_m = InRange("robot_radius_m", robot_radius_m, 0.01, 100.0);
  options.odometry.noise = InRange("odometry_noise", odometry_noise, 0.0, 1000.0);
  options.odometry.interference = InRange("interference", interference, 0.0, 1000.0);
  const WayPoints points = WayPointsOf(way_points);
  const simulation::Scene scene = SceneOf(world);

  Run run;
  Collector collector(&run.scans);
  const py::gil_scoped_release release;
  run.truth_map =
      simulation::TruthMap(scene.world, points.front(), scene.world.raster().resolution_m);
  run.summary = simulation::Simulate(scene, points, options, &collector);
  return run;
}

py::array ReadWayPoints(const std::filesystem::path& path) {
  const WayPoints points = simulation::ReadTours(path.string()).front();
  py::array_t<double> array({points.size(), std::size_t{2}});
  auto values = array.mutable_unchecked<2>();
  for (std::size_t k = 0; k < points.size(); ++k) {
    values(static_cast<py::ssize_t>(k), 0) = points[k].x();
    values(static_cast<py::ssize_t>(k), 1) = points[k].y();
  }
  return array;
}

}  // namespace

void BindSimulation(py::module_& module) {
  py::class_<Run>(module, "SimulatedRun", "What a simulated robot measured, and the truth.")
      .def_readonly("scans", &Run::scans, "List of LaserScan, in the order of time.")
      .def_property_readonly(
          "truth",
          [](const Run& run) {
            return Copied(run.summary.world_T_robot.data(), run.summary.world_T_robot.size());
          },
          "True pose at each scan: array of TRAJECTORY_DTYPE in the frame of the world.")
      .def_readonly("truth_map", &Run::truth_map, "The map that a perfect mapper would make.")
      .def_property_readonly(
          "path_length_m", [](const Run& run) { return run.summary.path_length_m; }, "m");
  const SimulationOptions d;
  module.def(
      "simulate", &Simulate, py::arg("world"), py::arg("way_points"), py::kw_only(),
      py::arg("seed") = d.seed, py::arg("beams") = d.lidar.beams,
      py::arg("fov_rad") = d.lidar.fov_rad, py::arg("scan_rate_hz") = d.lidar.rate_hz,
      py::arg("max_range_m") = d.lidar.max_range_m,
      py::arg("range_noise_m") = d.lidar.range_noise_m,
      py::arg("robot_T_laser") = py::make_tuple(0.0, 0.0, 0.0),
      py::arg("max_speed_m_s") = d.follower.max_speed_m_s,
      py::arg("robot_radius_m") = d.robot_radius_m, py::arg("odometry_noise") = d.odometry.noise,
      py::arg("interference") = d.odometry.interference,
      "Drives a robot with a laser and noisy wheels through a world; returns a SimulatedRun. The "
      "same arguments give the same run.\n\nworld: an OccupancyMap, whose occupied cells are "
      "solid, "
      "or the path of a world file. way_points: array (N, 2), positions in m in its frame. "
      "odometry_noise and interference are factors on the errors of the wheels; the others are the "
      "flags of the executable simulate.\n\nRaises ValueError on arguments out of range, "
      "RuntimeError when the robot would touch something or does not arrive.");
  module.def("read_way_points", &ReadWayPoints, py::arg("path"),
             "Reads the way points of a tour from YAML, an array (N, 2) in m.");
}

}  // namespace gmapping_spa::python
