// SPDX-License-Identifier: BSD-3-Clause
// A robot whose odometry and scans go through ControlInput.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_CONTROL_INPUT_ROOM_H_
#define GMAPPING_SPA_TESTS_FRONTEND_CONTROL_INPUT_ROOM_H_

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "frontend/control_input.h"
#include "tests/frontend/lidar_odometry_drive.h"
#include "tests/frontend/moving_laser.h"

namespace gmapping_spa::frontend {

// Drives the round of Drive; the odometry stands in the scans.
class ControlInputInARoom : public testing::Test {
 protected:
  void Start(OdometrySource source) {
    ControlInput::Options options;
    options.source = source;
    control_ = std::make_unique<ControlInput>(options, &health_);
  }

  sensor::LaserScan ScanAt(int step) {
    sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), OnRound(step));
    scan.stamp_s = 100.0 + 0.1 * step;
    scan.odom_T_robot = odom_T_world_ * OnRound(step);
    return scan;
  }

  ScanMotion Take(const sensor::LaserScan& scan) {
    const ScanMotion motion = control_->AddScan(scan);
    world_T_estimate_ = world_T_estimate_ * motion.motion;
    return motion;
  }

  void DriveUpTo(int last) {
    while (step_ <= last) Take(ScanAt(step_++));
  }

  std::vector<std::string> Findings() const {
    std::vector<std::string> kinds;
    for (const auto& [kind, finding] : health_.findings()) kinds.push_back(kind);
    return kinds;
  }
  using Kinds = std::vector<std::string>;

  Health health_;
  std::unique_ptr<ControlInput> control_;
  backend::SE2 odom_T_world_{3, -2, 0.7};
  backend::SE2 world_T_estimate_ = OnRound(0);
  int step_ = 0;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_TESTS_FRONTEND_CONTROL_INPUT_ROOM_H_
