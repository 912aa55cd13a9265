// SPDX-License-Identifier: BSD-3-Clause
// All that a page is told but runs: plain values.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_STATE_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_STATE_H_

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "backend/se2.h"
#include "experiments/drive/map_scorer.h"
#include "experiments/drive/slam_variant.h"
#include "experiments/simulation/shapes.h"
#include "experiments/simulation/way_point_follower.h"
#include "experiments/view/thinned_rows.h"

namespace gmapping_spa::drive {

// The run of the truth; those of variants follow.
inline constexpr int kTruthRun = 0;
inline constexpr int kMaxVariants = 4;
inline constexpr int kMaxParticles = 200;
inline constexpr int kMaxScores = 1024;  // that are kept of a variant

// What does not change.
struct DriveTitle {
  std::string world;
  backend::SE2 world_T_start;  // where maps of SLAM have their origin
  double robot_radius_m = 0.5;
  double truth_resolution_m = 0.05;
  double map_resolution_m = 0.05;
  std::vector<std::string> backends;  // to choose from
};

struct DriveStatus {
  std::string state;  // waiting, driving, paused, saving
  std::string note;   // for people; empty: none
  double time_s = 0.0;
  double path_m = 0.0;
  backend::SE2 world_T_robot;
  backend::SE2 world_T_odometry;  // where the wheels alone would take it to be
  simulation::BodyVelocity velocity;
  std::string blocked_by;  // empty: nothing
  simulation::WayPoints way;
  std::vector<simulation::Rectangle> walkers;
  double odometry_noise = 1.0;
  double slips_per_m = 0.01;
};

struct VariantStatus {
  VariantChoice choice;
  std::string state = "replaying";
  MapScore score = {};                             // the latest
  view::ThinnedRows<MapScore> scores{kMaxScores};  // so far
};

using VariantStatuses = std::map<int, VariantStatus>;  // by their runs

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_STATE_H_
