// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/simulation_flags.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/out_of_memory.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/simulation/truth_map.h"
#include "frontend/map/map_server_io.h"

namespace {
const gmapping_spa::simulation::SimulationOptions kDefault;
}  // namespace

DEFINE_string(world, "", "World file (YAML), as experiments/simulation/README.md describes it.");
DEFINE_string(
    path, "",
    "File of the tour's way points (YAML). Empty: the world file's name with .path.yaml.");
DEFINE_string(obstacles, "",
              "File of obstacles (YAML) to put into the world, such as "
              "worlds/paper_obstacles.yaml. Empty: none.");
DEFINE_bool(walking_pedestrian, false,
            "The pedestrian of --obstacles walks, and is not part of the true map.");
DEFINE_double(max_speed, kDefault.follower.max_speed_m_s,
              "Highest speed of the robot in m/s, from 0.01 to 100.");
DEFINE_double(max_turn_rate, kDefault.follower.max_turn_rate_rad_s,
              "Highest turn rate of the robot in rad/s, from 0.01 to 100.");
DEFINE_double(robot_radius, kDefault.robot_radius_m,
              "Radius of the robot in m, from 0.01 to 100; it must not touch anything.");
DEFINE_double(scan_rate, kDefault.lidar.rate_hz,
              "Number of scans per second, from 0.1 to 1000; odometry comes twice as often.");
DEFINE_double(angular_resolution, 360.0 / kDefault.lidar.beams,
              "Angle in degrees, from 0.001, from one beam to the next; it must divide --fov_deg.");
DEFINE_double(fov_deg, 360.0,
              "Field of view of the laser in degrees, 0 to 360, from the first beam to the last; "
              "360 is a whole turn.");
DEFINE_double(fov_center_deg, 0.0,
              "Direction in degrees, -360 to 360, of the middle of the field of view in the "
              "laser's frame: the first beam is half of --fov_deg before it.");
DEFINE_string(laser_mount, "0,0,0",
              "Pose x,y,theta (m, m, degrees) of the laser in the robot's frame, within 100 m and "
              "360 degrees: 0.2,0,180 looks to the rear.");
DEFINE_double(
    max_range, kDefault.lidar.max_range_m,
    "Largest range of the laser in m, from 0.01 to 10000; written where a beam has no return.");
DEFINE_double(range_noise, kDefault.lidar.range_noise_m,
              "Standard deviation of the noise of a range in m, from 0 to 100.");
DEFINE_bool(motion_during_scan, kDefault.lidar.motion_during_scan,
            "Each beam is measured at its own time while the laser turns, the middle of the field "
            "of view at the scan's stamp. Without it, all beams are measured at once.");
DEFINE_string(cover, "",
              "Times begin,end,begin,end,... in s from the start, ascending, between which the "
              "laser is covered: all beams read --cover_range. Empty: never.");
DEFINE_double(
    cover_range, kDefault.covered_range_m,
    "Range in m, from 0 to 10000, that a covered laser reads; --max_range or more is no return.");
DEFINE_string(scan_gaps, "",
              "Times begin,end,begin,end,... in s from the start, ascending, between which no "
              "scans are taken. Empty: none.");
DEFINE_bool(reverse, kDefault.follower.reverse,
            "The robot drives the tour in reverse gear: its rear goes first.");
DEFINE_double(turns_at_way_points, kDefault.follower.turns_at_way_points,
              "Number of full turns, -1000 to 1000, that the robot makes on the spot at each way "
              "point but the first; clockwise when negative.");
DEFINE_double(carry_s, kDefault.carry_s,
              "Time in s, from 0, that it takes to carry the robot to where another of the --path "
              "file's tours begins; meanwhile the wheels stand still and no scans are taken.");
DEFINE_int32(
    crowd, kDefault.walkers,
    "Number of people, 0 to 1000, who walk about within 12 m of the robot and never touch it.");
DEFINE_string(wheels, "noisy",
              "What the wheel odometry says: noisy (the truth with errors, which the flags from "
              "--odometry_noise to --wheel_base_factor describe), exact (the truth) or silent "
              "(always the pose 0 0 0).");
DEFINE_double(odometry_noise, kDefault.odometry.noise,
              "Factor, 0 to 1000, on the standard deviations of the odometry's normal noise; 1: "
              "that of good wheels.");
DEFINE_double(interference, kDefault.odometry.interference,
              "Factor, 0 to 1000, on the size of slips, bumps and biases of the odometry: all its "
              "errors that are not normal noise.");
DEFINE_double(slip_probability, kDefault.odometry.slips_per_m,
              "Number of slips of a wheel expected per m driven, 0 to 1000: for --slip_duration_s "
              "the wheel reports too much or too little.");
DEFINE_double(
    slip_size, kDefault.odometry.slip_deviation,
    "Standard deviation, 0 to 100, of the error of a slipping wheel, as a part of its travel.");
DEFINE_double(slip_duration_s, kDefault.odometry.slip_duration_s,
              "Time in s, 0 to 1000, that a slip of a wheel takes.");
DEFINE_double(bump_probability, kDefault.odometry.bumps_per_m,
              "Number of bumps expected per m driven, 0 to 1000: the odometry jumps from one "
              "reading to the next.");
DEFINE_double(
    bump_deg, kDefault.odometry.bump_deviation_rad * 180.0 / std::numbers::pi,
    "Standard deviation of the jump of the odometry's heading at a bump in degrees, 0 to 360.");
DEFINE_double(
    bump_m, kDefault.odometry.bump_deviation_m,
    "Standard deviation of the jump of the odometry along the heading at a bump in m, 0 to 100.");
DEFINE_double(calm_s, kDefault.odometry.calm_s,
              "Time in s, from 0, from the start without slips and bumps.");
DEFINE_double(wheel_scale_bias, kDefault.odometry.wheel_scale_deviation,
              "Standard deviation, 0 to 0.1, of the relative error of the size of both wheels; the "
              "seed draws one error for the whole tour.");
DEFINE_double(wheel_ratio_bias, kDefault.odometry.wheel_ratio_deviation,
              "Standard deviation, 0 to 0.1, of the relative difference between the sizes of the "
              "two wheels; the seed draws one difference for the whole tour.");
DEFINE_double(
    wheel_base_factor, kDefault.odometry.wheel_base_factor,
    "Distance between the wheels that the odometry assumes, as a part of the true one, 0.5 to 2: "
    "1.05 reports turns 5 % too small, 1 is exact. --interference does not scale it.");
DEFINE_double(truth_resolution, 0.05,
              "Edge length of a cell of the true map in m, from 0, a multiple of the world's; 0: "
              "that of the world.");

namespace gmapping_spa::apps {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

backend::SE2 LaserMount() {
  const std::vector<double> pose = Numbers("laser_mount", FLAGS_laser_mount);
  if (pose.size() != 3 || !(std::hypot(pose[0], pose[1]) <= 100.0 && std::abs(pose[2]) <= 360.0)) {
    FailFlag("laser_mount", FLAGS_laser_mount, "expected x,y,theta within 100 m and 360 degrees");
  }
  return {pose[0], pose[1], backend::WrapAngle(pose[2] * kRadPerDeg)};
}

std::vector<simulation::TimeSpan> TimeSpans(const char* flag, const std::string& text) {
  const std::vector<double> times_s = Numbers(flag, text);
  std::vector<simulation::TimeSpan> spans;
  for (std::size_t i = 0; i + 1 < times_s.size(); i += 2) {
    spans.push_back({times_s[i], times_s[i + 1]});
  }
  const bool ascending =
      std::adjacent_find(times_s.begin(), times_s.end(), std::greater_equal<>()) == times_s.end();
  if (times_s.size() % 2 != 0 || !ascending) {
    FailFlag(flag, text, "expected an even number of ascending times");
  }
  return spans;
}

simulation::LidarOptions LidarOptionsFromFlags() {
  simulation::LidarOptions lidar;
  const double fov_deg = InRange("fov_deg", FLAGS_fov_deg, 0.0, 360.0);
  const double steps =
      fov_deg / InRange("angular_resolution", FLAGS_angular_resolution, 0.001, 360.0);
  if (std::abs(steps - std::round(steps)) > 1e-6 * steps) {
    throw std::runtime_error("--angular_resolution: expected degrees that divide the " +
                             std::to_string(fov_deg) + " of --fov_deg, found " +
                             std::to_string(FLAGS_angular_resolution));
  }
  lidar.fov_rad = fov_deg * kRadPerDeg;
  lidar.fov_center_rad =
      InRange("fov_center_deg", FLAGS_fov_center_deg, -360.0, 360.0) * kRadPerDeg;
  lidar.beams = static_cast<int>(std::lround(steps)) + (lidar.all_round() ? 0 : 1);
  lidar.robot_T_laser = LaserMount();
  lidar.motion_during_scan = FLAGS_motion_during_scan;
  lidar.rate_hz = InRange("scan_rate", FLAGS_scan_rate, 0.1, 1000.0);
  lidar.max_range_m = InRange("max_range", FLAGS_max_range, 0.01, 10000.0);
  lidar.range_noise_m = InRange("range_noise", FLAGS_range_noise, 0.0, 100.0);
  return lidar;
}

enum class Wheels { kNoisy, kExact, kSilent };
constexpr backend::EnumName<Wheels> kWheels[] = {
    {"noisy", Wheels::kNoisy}, {"exact", Wheels::kExact}, {"silent", Wheels::kSilent}};

simulation::SimulationOptions OptionsFromFlags(std::uint64_t seed) {
  simulation::SimulationOptions options;
  options.seed = seed;
  options.robot_radius_m = InRange("robot_radius", FLAGS_robot_radius, 0.01, 100.0);
  options.follower.max_speed_m_s = InRange("max_speed", FLAGS_max_speed, 0.01, 100.0);
  options.follower.max_turn_rate_rad_s = InRange("max_turn_rate", FLAGS_max_turn_rate, 0.01, 100.0);
  options.follower.reverse = FLAGS_reverse;
  options.follower.turns_at_way_points =
      InRange("turns_at_way_points", FLAGS_turns_at_way_points, -1000.0, 1000.0);
  options.carry_s = InRange("carry_s", FLAGS_carry_s, 0.0, 1e5);
  options.covered = TimeSpans("cover", FLAGS_cover);
  options.covered_range_m = InRange("cover_range", FLAGS_cover_range, 0.0, 1e4);
  options.without_scan = TimeSpans("scan_gaps", FLAGS_scan_gaps);
  options.walkers = InRange("crowd", FLAGS_crowd, 0, 1000);
  options.lidar = LidarOptionsFromFlags();
  simulation::OdometryOptions& odometry = options.odometry;
  odometry.noise = InRange("odometry_noise", FLAGS_odometry_noise, 0.0, 1000.0);
  odometry.interference = InRange("interference", FLAGS_interference, 0.0, 1000.0);
  odometry.slip_deviation = InRange("slip_size", FLAGS_slip_size, 0.0, 100.0);
  odometry.slip_duration_s = InRange("slip_duration_s", FLAGS_slip_duration_s, 0.0, 1000.0);
  odometry.bump_deviation_rad = InRange("bump_deg", FLAGS_bump_deg, 0.0, 360.0) * kRadPerDeg;
  odometry.bump_deviation_m = InRange("bump_m", FLAGS_bump_m, 0.0, 100.0);
  odometry.calm_s = InRange("calm_s", FLAGS_calm_s, 0.0, 1e9);
  odometry.slips_per_m = InRange("slip_probability", FLAGS_slip_probability, 0.0, 1000.0);
  odometry.bumps_per_m = InRange("bump_probability", FLAGS_bump_probability, 0.0, 1000.0);
  odometry.wheel_scale_deviation = InRange("wheel_scale_bias", FLAGS_wheel_scale_bias, 0.0, 0.1);
  odometry.wheel_ratio_deviation = InRange("wheel_ratio_bias", FLAGS_wheel_ratio_bias, 0.0, 0.1);
  odometry.wheel_base_factor = InRange("wheel_base_factor", FLAGS_wheel_base_factor, 0.5, 2.0);
  const Wheels wheels = OneOf("wheels", FLAGS_wheels, kWheels);
  odometry.silent = wheels == Wheels::kSilent;
  if (wheels != Wheels::kNoisy) {
    odometry.noise = odometry.interference = odometry.slips_per_m = odometry.bumps_per_m = 0.0;
    odometry.wheel_base_factor = 1.0;
  }
  return options;
}

SimulationSetup SetupFromFlags(std::uint64_t seed) {
  if (FLAGS_world.empty()) throw std::runtime_error("--world=FILE is missing");
  simulation::SimulationOptions options = OptionsFromFlags(seed);
  const double truth_resolution_m =
      InRange("truth_resolution", FLAGS_truth_resolution, 0.0, 1000.0);
  const std::string path =
      FLAGS_path.empty()
          ? std::filesystem::path(FLAGS_world).replace_extension("path.yaml").string()
          : FLAGS_path;
  if (FLAGS_path.empty() && std::filesystem::exists(FLAGS_world) &&
      !std::filesystem::exists(path)) {
    throw std::runtime_error("--path=FILE is missing, and there is no " + path +
                             " beside the world");
  }
  std::map<std::string, std::string> input_files = {{"world", FLAGS_world}, {"path", path}};
  if (!FLAGS_obstacles.empty()) input_files["obstacles"] = FLAGS_obstacles;
  simulation::Scene scene =
      simulation::Scene::Read(FLAGS_world, FLAGS_obstacles, FLAGS_walking_pedestrian);
  std::vector<simulation::WayPoints> tours = simulation::ReadTours(path);
  simulation::WayPoints way_points = std::move(tours.front());
  options.carried_to.assign(std::next(tours.begin()), tours.end());
  const auto truth_of = [&](const simulation::World& world) {
    const map::TrinaryMap& raster = world.raster();
    return backend::WithMemory(
        "while drawing the true map: " + backend::MemoryOfCells(raster.width, raster.height, 3),
        [&] {
          return simulation::TruthMap(
              world, way_points.front(),
              truth_resolution_m > 0.0 ? truth_resolution_m : raster.resolution_m);
        });
  };
  map::TrinaryMap truth = truth_of(scene.world);
  std::optional<map::TrinaryMap> obstacles;
  if (!FLAGS_obstacles.empty()) {
    obstacles =
        simulation::Added(truth, truth_of(simulation::Scene::Read(FLAGS_world, "", false).world));
  }
  return {std::move(input_files), std::move(scene),    std::move(way_points), options,
          std::move(truth),       std::move(obstacles)};
}

}  // namespace

FlagGroups SimulationFlagGroups() {
  return {{"tour",
           "World and tour",
           {"world", "path", "obstacles", "walking_pedestrian", "crowd", "turns_at_way_points",
            "carry_s", "truth_resolution"}},
          {"robot", "Robot", {"max_speed", "max_turn_rate", "robot_radius", "reverse"}},
          {"laser",
           "Laser",
           {"scan_rate", "angular_resolution", "fov_deg", "fov_center_deg", "laser_mount",
            "max_range", "range_noise", "motion_during_scan", "cover", "cover_range", "scan_gaps"}},
          {"wheels",
           "Wheel odometry",
           {"wheels", "odometry_noise", "interference", "slip_probability", "slip_size",
            "slip_duration_s", "bump_probability", "bump_deg", "bump_m", "calm_s",
            "wheel_scale_bias", "wheel_ratio_bias", "wheel_base_factor"}}};
}

SimulationSetup SimulationFromFlags(std::uint64_t seed) {
  return backend::WithMemory("while building the world of " + FLAGS_world,
                             [&] { return SetupFromFlags(seed); });
}

void WriteTruth(const SimulationSetup& setup, const simulation::SimulationSummary& summary,
                OutputFiles* files) {
  files->Write("truth.tum",
               [&](std::ostream& out) { backend::WriteTum(summary.world_T_robot, out); });
  const auto write_map = [&](const map::TrinaryMap& map, const std::string& name) {
    files->Write(name + ".pgm", [&](std::ostream& out) { map::WritePgm(map, out); });
    files->Write(name + ".yaml",
                 [&](std::ostream& out) { map::WriteMapYaml(map, name + ".pgm", out); });
  };
  write_map(setup.truth, "truth");
  if (setup.obstacles) write_map(*setup.obstacles, "truth_obstacles");
}

}  // namespace gmapping_spa::apps
