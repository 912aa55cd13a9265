// SPDX-License-Identifier: BSD-3-Clause
// A room seen by a robot whose laser is not at its center.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_ROOM_H_
#define GMAPPING_SPA_TESTS_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_ROOM_H_

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "backend/counter_random.h"
#include "frontend/scan_matching/scan_points.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::scan_matching {

inline constexpr double kDeg = std::numbers::pi / 180.0;

inline const synthetic::Laser kLaser{.robot_T_laser = {0.25, -0.1, 0.3}};

// As RoomMap.
inline map::OccupancyGrid OffsetLaserRoomMap() {
  std::vector<backend::SE2> poses;
  for (int i = 0; i < 36; ++i) {
    const double around = 0.55 * i;
    poses.push_back({1.3 * std::cos(around), 1.1 * std::sin(around), 2.1 * i});
  }
  return synthetic::MapFrom(synthetic::Room(), poses, kLaser);
}

inline ScanPoints RoomPoints(const backend::SE2& world_T_robot) {
  return MakeScanPoints(synthetic::Scan(synthetic::Room(), world_T_robot, kLaser));
}

class GaussNewtonInRoom : public testing::Test {
 protected:
  double Offset(double limit) { return limit * (2.0 * random_.Uniform() - 1.0); }
  backend::SE2 RandomPose() { return {Offset(1.2), Offset(1.0), Offset(std::numbers::pi)}; }
  backend::SE2 Near(const backend::SE2& pose, double m, double rad) {
    return pose * backend::SE2{Offset(m), Offset(m), Offset(rad)};
  }

  const map::OccupancyGrid grid_ = OffsetLaserRoomMap();
  backend::CounterRandom random_{11, 0};
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_TESTS_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_ROOM_H_
