#include "experiments/simulation/lidar.h"

#include <algorithm>

#include "backend/counter_random.h"
#include "experiments/simulation/random_streams.h"

namespace gmapping_spa::simulation {

std::vector<double> Scan(const Scene& scene, double time_s, const backend::SE2& world_T_laser,
                         const LidarOptions& options, std::uint64_t seed, std::uint32_t scan) {
  std::vector<double> ranges_m(options.beams, options.max_range_m);
  for (int beam = 0; beam < options.beams; ++beam) {
    const double angle_rad = options.start_angle_rad() + beam * options.angular_resolution_rad();
    const std::optional<double> range_m = scene.CastRay(
        world_T_laser.translation(), world_T_laser.theta + angle_rad, options.max_range_m, time_s);
    if (!range_m) continue;
    backend::CounterRandom random(seed, kLidarStream, scan, beam);
    ranges_m[beam] =
        std::clamp(*range_m + options.range_noise_m * random.Gaussian(), 0.0, options.max_range_m);
  }
  return ranges_m;
}

}  // namespace gmapping_spa::simulation
