// SPDX-License-Identifier: BSD-3-Clause
// Opening bags of ROS 1 and ROS 2, without ROS.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_OPEN_BAG_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_OPEN_BAG_H_

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "backend/se2.h"
#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::rosbag {

// What a bag holds and what is made of it.
struct BagReport {
  struct Topic {
    std::string name, type;
    std::int64_t messages = 0;
    std::string used_for;  // "scans", "odometry", "transforms"; empty: it is not read
  };
  // A frame of scans.
  struct Laser {
    std::string frame;
    backend::SE2 robot_T_laser;
    bool upside_down = false;
    double tilt_rad = 0.0;  // between its plane and the robot's
    std::string from;       // "tf", "assumed" (it is where the robot is), "--laser_pose"
  };

  std::string format;
  double first_s = 0.0, last_s = 0.0;  // times of recording
  std::vector<Topic> topics;
  // What is known when scans have been read:
  std::string base_frame;     // whose poses the trajectory has; empty where nothing tells it
  std::string odometry_from;  // a topic, or the transform
  std::vector<Laser> lasers;
};

struct Bag {
  std::unique_ptr<sensor::LogReader> reader;
  std::shared_ptr<const BagReport> report;  // grows while scans are read
};

// Whether these are the first bytes of a bag, 16 at least where there are as many.
bool BeginsAsABag(std::string_view bytes);

// Whether a file begins as a bag does, or the path is that of a folder.
bool IsBag(const std::string& path);

// Opens a ROS 1 bag, a ROS 2 bag (MCAP, db3) or a folder with such: README.md of this folder tells
// what is read of it. Holds a bounded part of the bag in memory. Throws std::runtime_error with one
// line where the bag is damaged or holds no scans, std::invalid_argument on options out of range.
Bag OpenBag(const std::string& path, const sensor::LogOptions& options);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_OPEN_BAG_H_
