// A scanning range finder that sees all around.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_

#include <cstdint>
#include <numbers>
#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/scene.h"

namespace gmapping_spa::simulation {

// Defaults are those of the LSLIDAR N301, the paper's laser: 360 degrees, 10 Hz, up to 30 m. Its
// driver's README (UbiquityRobotics/ur50_lidar on GitHub) gives 1000 points a turn for version 0.2
// of the protocol, and 2000 for 0.1. The range of 30 m and the accuracy of +-3 cm are those of the
// vendor's data sheet as commonly quoted: no copy of it could be had to check them, and what
// "accuracy" means there is not known. It is taken for a bound of 95 %, two standard deviations.
struct LidarOptions {
  int beams = 1000;  // a turn, from -180 degrees, counter-clockwise
  double rate_hz = 10.0;
  double max_range_m = 30.0;
  double range_noise_m = 0.015;  // standard deviation

  double start_angle_rad() const { return -std::numbers::pi; }
  double angular_resolution_rad() const { return 2.0 * std::numbers::pi / beams; }
};

// The ranges, in m, of the scan with this number, all taken at `time_s` from the laser's pose.
// Normal noise is added to each; max_range_m stands for no return.
std::vector<double> Scan(const Scene& scene, double time_s, const backend::SE2& world_T_laser,
                         const LidarOptions& options, std::uint64_t seed, std::uint32_t scan);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_
