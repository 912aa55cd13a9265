// SPDX-License-Identifier: BSD-3-Clause
// The tour so far: what was commanded, and what the sensors said. In any thread.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_RECORDED_TOUR_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_RECORDED_TOUR_H_

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <istream>
#include <mutex>
#include <ostream>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "experiments/drive/driven_robot.h"
#include "experiments/simulation/log_sink.h"

namespace gmapping_spa::drive {

class RecordedTour {
 public:
  explicit RecordedTour(const simulation::LidarOptions& lidar) : lidar_(lidar) {}

  // Lets the robot do a step, and records it.
  void Drive(const DriveCommand& command, DrivenRobot* robot);

  std::size_t steps() const;
  // Whether there are more than `steps` of them by then.
  bool WaitForMore(std::size_t steps, std::chrono::milliseconds patience) const;

  // Hands the readings of the steps [from, to) to `sink`, as they were.
  void Play(std::size_t from, std::size_t to, simulation::LogSink* sink) const;

  // world_T_robot at the scans of the steps [from, to).
  backend::Trajectory TrueTrajectory(std::size_t from, std::size_t to) const;

  // A line a command, with as many digits as it takes to read the same numbers again.
  void WriteCommands(std::ostream& out) const;

 private:
  struct Step {
    DriveCommand command;
    std::vector<simulation::OdometryReading> odometry;
    // The first reading's; empty without a scan.
    std::vector<std::int32_t> ranges_mm;
    backend::StampedPose truth;
  };

  const simulation::LidarOptions lidar_;
  mutable std::mutex mutex_;
  mutable std::condition_variable has_grown_;
  std::deque<Step> steps_;  // which stay where they are
};

// Throws std::runtime_error "<name>:<line>: <what was expected, what was found>".
std::vector<DriveCommand> ReadCommands(std::istream& in, const std::string& name);

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_RECORDED_TOUR_H_
