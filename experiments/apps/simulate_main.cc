// Simulates a robot's tour of a building: its sensor log, its true trajectory and the true map.
#include <gflags/gflags.h>
#include <glog/logging.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "backend/trajectory_io.h"
#include "experiments/apps/app.h"
#include "experiments/apps/output_files.h"
#include "experiments/simulation/simulation.h"
#include "experiments/simulation/truth_map.h"
#include "frontend/map/map_server_io.h"

namespace {
const gmapping_spa::simulation::SimulationOptions kDefault;
}  // namespace

DEFINE_string(world, "", "World file (YAML): see experiments/simulation/README.md.");
DEFINE_string(path, "",
              "Way points of the tour (YAML). Empty: the world file's name with .path.yaml.");
DEFINE_string(output_dir, "", "Folder for log.clf, truth.tum, truth.pgm and truth.yaml.");
DEFINE_uint64(seed, kDefault.seed, "Seed of all noise.");
DEFINE_double(max_speed, kDefault.follower.max_speed_m_s, "Highest speed, m/s.");
DEFINE_double(max_turn_rate, kDefault.follower.max_turn_rate_rad_s, "Highest turn rate, rad/s.");
DEFINE_double(robot_radius, kDefault.robot_radius_m,
              "Radius in m of the robot, which must not touch anything.");
DEFINE_double(scan_rate, kDefault.lidar.rate_hz, "Scans a second; odometry comes twice as often.");
DEFINE_int32(beams, kDefault.lidar.beams, "Beams of a scan, over 360 degrees.");
DEFINE_double(max_range, kDefault.lidar.max_range_m,
              "Range of the laser in m; written where a beam has no return.");
DEFINE_double(range_noise, kDefault.lidar.range_noise_m, "Standard deviation of a range, m.");
DEFINE_double(odometry_noise, kDefault.odometry.noise,
              "Factor on the standard deviations of the odometry's normal noise.");
DEFINE_double(slip_probability, kDefault.odometry.slip_probability_per_m,
              "Probability per metre that a wheel starts to slip or the heading jumps.");
DEFINE_double(truth_resolution, 0.05,
              "Cell size in m of the true map, a multiple of the world's; 0: the world's.");

namespace gmapping_spa::apps {
namespace {

void CheckRange(const char* name, double value, double min, double max) {
  if (value >= min && value <= max) return;
  throw std::runtime_error("--" + std::string(name) + ": expected a value from " +
                           std::to_string(min) + " to " + std::to_string(max) + ", found " +
                           std::to_string(value));
}

simulation::SimulationOptions OptionsFromFlags() {
  CheckRange("max_speed", FLAGS_max_speed, 0.01, 100.0);
  CheckRange("max_turn_rate", FLAGS_max_turn_rate, 0.01, 100.0);
  CheckRange("robot_radius", FLAGS_robot_radius, 0.01, 100.0);
  CheckRange("scan_rate", FLAGS_scan_rate, 0.1, 1000.0);
  CheckRange("beams", FLAGS_beams, 1, 100000);
  CheckRange("max_range", FLAGS_max_range, 0.01, 10000.0);
  CheckRange("range_noise", FLAGS_range_noise, 0.0, 100.0);
  CheckRange("odometry_noise", FLAGS_odometry_noise, 0.0, 1000.0);
  CheckRange("slip_probability", FLAGS_slip_probability, 0.0, 1000.0);
  CheckRange("truth_resolution", FLAGS_truth_resolution, 0.0, 1000.0);
  simulation::SimulationOptions options;
  options.seed = FLAGS_seed;
  options.robot_radius_m = FLAGS_robot_radius;
  options.follower.max_speed_m_s = FLAGS_max_speed;
  options.follower.max_turn_rate_rad_s = FLAGS_max_turn_rate;
  options.lidar.rate_hz = FLAGS_scan_rate;
  options.lidar.beams = FLAGS_beams;
  options.lidar.max_range_m = FLAGS_max_range;
  options.lidar.range_noise_m = FLAGS_range_noise;
  options.odometry.noise = FLAGS_odometry_noise;
  options.odometry.slip_probability_per_m = FLAGS_slip_probability;
  return options;
}

void Run() {
  if (FLAGS_world.empty()) throw std::runtime_error("--world=FILE is missing");
  if (FLAGS_output_dir.empty()) throw std::runtime_error("--output_dir=DIR is missing");
  const simulation::SimulationOptions options = OptionsFromFlags();
  const std::string path =
      FLAGS_path.empty()
          ? std::filesystem::path(FLAGS_world).replace_extension("path.yaml").string()
          : FLAGS_path;
  const simulation::World world = simulation::World::Read(FLAGS_world);
  const simulation::WayPoints way_points = simulation::ReadWayPoints(path);
  const map::TrinaryMap truth = simulation::TruthMap(
      world, way_points.front(),
      FLAGS_truth_resolution > 0.0 ? FLAGS_truth_resolution : world.raster().resolution_m);

  OutputFiles files(FLAGS_output_dir);
  simulation::SimulationSummary summary;
  files.Write("log.clf", [&](std::ostream& out) {
    summary = simulation::Simulate(world, way_points, options, out, ThrowIfInterrupted);
  });
  files.Write("truth.tum",
              [&](std::ostream& out) { backend::WriteTum(summary.world_T_robot, out); });
  files.Write("truth.pgm", [&](std::ostream& out) { map::WritePgm(truth, out); });
  files.Write("truth.yaml", [&](std::ostream& out) { map::WriteMapYaml(truth, "truth.pgm", out); });
  files.Commit();

  const backend::SE2 end = summary.world_T_robot.back().world_T_robot;
  const backend::SE2 odometry_end =
      summary.world_T_robot.front().world_T_robot * summary.odom_T_robot;
  LOG(INFO) << summary.world_T_robot.size() << " scans over " << summary.path_length_m << " m in "
            << summary.world_T_robot.back().stamp_s << " s; odometry ends "
            << (odometry_end.translation() - end.translation()).norm() << " m off, "
            << summary.slip_events << " slip events";
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "simulates a robot with a laser that drives a tour of a building.\n"
      "Usage: simulate --world=FILE --output_dir=DIR [--path=FILE] [--seed=S] ...\n"
      "Writes log.clf (CARMEN), truth.tum (true pose at each scan) and the true map truth.pgm with "
      "truth.yaml.",
      gmapping_spa::apps::Run);
}
