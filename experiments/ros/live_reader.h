// SPDX-License-Identifier: BSD-3-Clause
// Scans, with the odometry at their time, of messages that come while the robot drives.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_LIVE_READER_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_LIVE_READER_H_

#include <memory>

#include "experiments/ros/live_source.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::ros {

// As bags are read, but for the rules that hold back 200 scans (frontend/sensor/beam_filter.h).
// `source` outlives it.
std::unique_ptr<sensor::LogReader> MakeLiveReader(LiveSource* source);

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_LIVE_READER_H_
