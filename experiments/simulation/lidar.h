// A scanning range finder that sees all around.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_

#include <cstdint>
#include <numbers>
#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/world.h"

namespace gmapping_spa::simulation {

struct LidarOptions {
  // One beam a degree, as in most logs of the field: twice as many double the log and tell a
  // matcher little more. From -180 degrees, counter-clockwise.
  int beams = 360;
  double rate_hz = 10.0;
  double max_range_m = 30.0;
  // Standard deviation of a range: between those of a Hokuyo UTM-30LX below and above 10 m (0.01
  // and 0.03 m in its data sheet).
  double range_noise_m = 0.02;

  double start_angle_rad() const { return -std::numbers::pi; }
  double angular_resolution_rad() const { return 2.0 * std::numbers::pi / beams; }
};

// The ranges, in m, of the scan with this number, all taken at once from the laser's pose. Normal
// noise is added to each; max_range_m stands for no return.
std::vector<double> Scan(const World& world, const backend::SE2& world_T_laser,
                         const LidarOptions& options, std::uint64_t seed, std::uint32_t scan);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_
