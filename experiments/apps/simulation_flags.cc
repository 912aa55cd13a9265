#include "experiments/apps/simulation_flags.h"

#include <gflags/gflags.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "backend/trajectory_io.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/simulation/truth_map.h"
#include "frontend/map/map_server_io.h"

namespace {
const gmapping_spa::simulation::SimulationOptions kDefault;
}  // namespace

DEFINE_string(world, "", "World file (YAML): see experiments/simulation/README.md.");
DEFINE_string(path, "",
              "Way points of the tour (YAML). Empty: the world file's name with .path.yaml.");
DEFINE_string(
    obstacles, "",
    "File of obstacles (YAML) to put into the world, such as worlds/paper_obstacles.yaml.");
DEFINE_bool(walking_pedestrian, false,
            "The pedestrian of --obstacles walks, and is not part of the true map.");
DEFINE_double(max_speed, kDefault.follower.max_speed_m_s, "Highest speed, m/s.");
DEFINE_double(max_turn_rate, kDefault.follower.max_turn_rate_rad_s, "Highest turn rate, rad/s.");
DEFINE_double(robot_radius, kDefault.robot_radius_m,
              "Radius in m of the robot, which must not touch anything.");
DEFINE_double(scan_rate, kDefault.lidar.rate_hz, "Scans a second; odometry comes twice as often.");
DEFINE_double(angular_resolution, 360.0 / kDefault.lidar.beams,
              "Degrees from beam to beam, such that they divide 360.");
DEFINE_double(max_range, kDefault.lidar.max_range_m,
              "Range of the laser in m; written where a beam has no return.");
DEFINE_double(range_noise, kDefault.lidar.range_noise_m, "Standard deviation of a range, m.");
DEFINE_bool(motion_during_scan, kDefault.lidar.motion_during_scan,
            "Each beam is measured at its time in the laser's turn, that straight ahead at the "
            "scan's stamp; else all at once.");
DEFINE_double(odometry_noise, kDefault.odometry.noise,
              "Factor on the standard deviations of the odometry's normal noise.");
DEFINE_double(interference, kDefault.odometry.interference,
              "Factor on the size of slips, bumps and biases: all that is not normal noise.");
DEFINE_double(slip_probability, kDefault.odometry.slips_per_m,
              "Probability per metre that a wheel starts to slip: it reports some tens of per cent "
              "too much or too little for 0.4 s.");
DEFINE_double(
    bump_probability, kDefault.odometry.bumps_per_m,
    "Probability per metre that the robot is knocked: its heading jumps by some degrees.");
DEFINE_double(wheel_scale_bias, kDefault.odometry.wheel_scale_deviation,
              "Standard deviation of the error of both wheels' size, as a part of it; the seed "
              "draws one for the whole tour.");
DEFINE_double(wheel_ratio_bias, kDefault.odometry.wheel_ratio_deviation,
              "The same of how much larger one wheel is than the other.");
DEFINE_double(truth_resolution, 0.05,
              "Cell size in m of the true map, a multiple of the world's; 0: the world's.");

namespace gmapping_spa::apps {
namespace {

simulation::LidarOptions LidarOptionsFromFlags() {
  simulation::LidarOptions lidar;
  const double beams =
      360.0 / InRange("angular_resolution", FLAGS_angular_resolution, 0.001, 360.0);
  lidar.beams = static_cast<int>(std::lround(beams));
  if (std::abs(beams - lidar.beams) > 1e-6 * beams) {
    throw std::runtime_error("--angular_resolution: expected degrees that divide 360, found " +
                             std::to_string(FLAGS_angular_resolution));
  }
  lidar.motion_during_scan = FLAGS_motion_during_scan;
  lidar.rate_hz = InRange("scan_rate", FLAGS_scan_rate, 0.1, 1000.0);
  lidar.max_range_m = InRange("max_range", FLAGS_max_range, 0.01, 10000.0);
  lidar.range_noise_m = InRange("range_noise", FLAGS_range_noise, 0.0, 100.0);
  return lidar;
}

simulation::SimulationOptions OptionsFromFlags(std::uint64_t seed) {
  simulation::SimulationOptions options;
  options.seed = seed;
  options.robot_radius_m = InRange("robot_radius", FLAGS_robot_radius, 0.01, 100.0);
  options.follower.max_speed_m_s = InRange("max_speed", FLAGS_max_speed, 0.01, 100.0);
  options.follower.max_turn_rate_rad_s = InRange("max_turn_rate", FLAGS_max_turn_rate, 0.01, 100.0);
  options.lidar = LidarOptionsFromFlags();
  simulation::OdometryOptions& odometry = options.odometry;
  odometry.noise = InRange("odometry_noise", FLAGS_odometry_noise, 0.0, 1000.0);
  odometry.interference = InRange("interference", FLAGS_interference, 0.0, 1000.0);
  odometry.slips_per_m = InRange("slip_probability", FLAGS_slip_probability, 0.0, 1000.0);
  odometry.bumps_per_m = InRange("bump_probability", FLAGS_bump_probability, 0.0, 1000.0);
  odometry.wheel_scale_deviation = InRange("wheel_scale_bias", FLAGS_wheel_scale_bias, 0.0, 0.1);
  odometry.wheel_ratio_deviation = InRange("wheel_ratio_bias", FLAGS_wheel_ratio_bias, 0.0, 0.1);
  return options;
}

}  // namespace

SimulationSetup SimulationFromFlags(std::uint64_t seed) {
  if (FLAGS_world.empty()) throw std::runtime_error("--world=FILE is missing");
  simulation::SimulationOptions options = OptionsFromFlags(seed);
  const double truth_resolution_m =
      InRange("truth_resolution", FLAGS_truth_resolution, 0.0, 1000.0);
  const std::string path =
      FLAGS_path.empty()
          ? std::filesystem::path(FLAGS_world).replace_extension("path.yaml").string()
          : FLAGS_path;
  std::map<std::string, std::string> input_files = {{"world", FLAGS_world}, {"path", path}};
  if (!FLAGS_obstacles.empty()) input_files["obstacles"] = FLAGS_obstacles;
  simulation::Scene scene =
      simulation::Scene::Read(FLAGS_world, FLAGS_obstacles, FLAGS_walking_pedestrian);
  simulation::WayPoints way_points = simulation::ReadWayPoints(path);
  map::TrinaryMap truth = simulation::TruthMap(
      scene.world, way_points.front(),
      truth_resolution_m > 0.0 ? truth_resolution_m : scene.world.raster().resolution_m);
  return {std::move(input_files), std::move(scene), std::move(way_points), options,
          std::move(truth)};
}

void WriteTruth(const SimulationSetup& setup, const simulation::SimulationSummary& summary,
                OutputFiles* files) {
  files->Write("truth.tum",
               [&](std::ostream& out) { backend::WriteTum(summary.world_T_robot, out); });
  files->Write("truth.pgm", [&](std::ostream& out) { map::WritePgm(setup.truth, out); });
  files->Write("truth.yaml",
               [&](std::ostream& out) { map::WriteMapYaml(setup.truth, "truth.pgm", out); });
}

}  // namespace gmapping_spa::apps
