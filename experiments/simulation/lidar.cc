// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/lidar.h"

#include <algorithm>

#include "backend/counter_random.h"
#include "experiments/simulation/random_streams.h"

namespace gmapping_spa::simulation {

std::vector<double> Scan(const Scene& scene, const Sweep& sweep, const LidarOptions& options,
                         std::uint64_t seed, std::uint32_t scan) {
  std::vector<double> ranges_m(options.beams, options.max_range_m);
  backend::SE2 world_T_laser = sweep.world_T_robot * options.robot_T_laser;
  double time_s = sweep.stamp_s;
  for (int beam = 0; beam < options.beams; ++beam) {
    const double angle_rad = options.start_angle_rad() + beam * options.angular_resolution_rad();
    if (options.motion_during_scan) {
      const double after_stamp_s =
          (angle_rad - options.fov_center_rad) / (2.0 * std::numbers::pi) / options.rate_hz;
      world_T_laser = Drive(sweep.world_T_robot, after_stamp_s < 0.0 ? sweep.before : sweep.after,
                            after_stamp_s) *
                      options.robot_T_laser;
      time_s = std::max(0.0, sweep.stamp_s + after_stamp_s);  // everything stands before time 0
    }
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
