// SPDX-License-Identifier: BSD-3-Clause
// Drives through synthetic worlds by which lidar odometry is tried out.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LIDAR_ODOMETRY_DRIVE_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LIDAR_ODOMETRY_DRIVE_H_

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "backend/counter_random.h"
#include "frontend/lidar_odometry.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::frontend {

constexpr double kDeg = std::numbers::pi / 180.0;

using Wheels = sensor::OdometryCheck::Step;

// Around the middle of Room(), a round in 80 steps of about 0.1 m.
inline backend::SE2 OnRound(int step) {
  const double around = 2.0 * std::numbers::pi * step / 80.0;
  return {1.3 * std::cos(around), 1.3 * std::sin(around),
          backend::WrapAngle(around + std::numbers::pi / 2)};
}
inline backend::SE2 StepOfRound(int step) {
  return step == 0 ? backend::SE2{} : Between(OnRound(step - 1), OnRound(step));
}

inline void ExpectNear(const backend::SE2& found, const backend::SE2& expected, double m,
                       double rad) {
  const backend::SE2 off = Between(expected, found);
  EXPECT_LT(off.translation().norm(), m) << off.x << ' ' << off.y << ' ' << off.theta;
  EXPECT_LT(std::abs(off.theta), rad) << off.x << ' ' << off.y << ' ' << off.theta;
}

// A robot that takes ten scans a second, with a centimetre of noise, and its lidar odometry.
class Drive {
 public:
  explicit Drive(synthetic::Walls walls, const synthetic::Laser& laser = {},
                 const LidarOdometry::Options& options = {})
      : walls_(std::move(walls)), laser_(laser), odometry_(options) {}

  sensor::LaserScan ScanAt(const backend::SE2& world_T_robot) {
    sensor::LaserScan scan = synthetic::Scan(walls_, world_T_robot, laser_);
    for (sensor::Beam& beam : scan.beams) {
      if (beam.status == sensor::BeamStatus::kHit) beam.range_m += 0.01 * random_.Gaussian();
    }
    return scan;
  }

  // To the pose, at which the wheels say that they have made this step.
  ScanMotion To(const backend::SE2& world_T_robot, const Wheels& wheels) {
    return Take(ScanAt(world_T_robot), world_T_robot, wheels);
  }
  // With exact wheels.
  ScanMotion To(const backend::SE2& world_T_robot) {
    return To(world_T_robot, {Between(world_T_robot_, world_T_robot)});
  }

  // As To, with a scan that may be of anything.
  ScanMotion Take(sensor::LaserScan scan, const backend::SE2& world_T_robot, const Wheels& wheels) {
    scan.stamp_s = stamp_s_;
    stamp_s_ += 0.1;
    const ScanMotion motion = odometry_.MatchScan(scan, wheels);
    world_T_robot_ = world_T_robot;
    if (!started_) world_T_estimate_ = world_T_robot;
    started_ = true;
    world_T_estimate_ = world_T_estimate_ * motion.motion;
    return motion;
  }

  // No scans for so long.
  void Wait(double duration_s) { stamp_s_ += duration_s; }

  void ExpectIsWhereItIs(double m, double rad) const {
    ExpectNear(world_T_estimate_, world_T_robot_, m, rad);
  }

  const backend::SE2& world_T_robot() const { return world_T_robot_; }
  const backend::SE2& world_T_estimate() const { return world_T_estimate_; }

 private:
  synthetic::Walls walls_;
  synthetic::Laser laser_;
  LidarOdometry odometry_;
  backend::CounterRandom random_{3, 0};
  double stamp_s_ = 1000.0;
  bool started_ = false;
  backend::SE2 world_T_robot_;
  backend::SE2 world_T_estimate_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LIDAR_ODOMETRY_DRIVE_H_
