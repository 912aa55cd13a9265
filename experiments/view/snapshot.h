// SPDX-License-Identifier: BSD-3-Clause
// What a run of SLAM looks like at a moment: plain values, for another thread to show.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_SNAPSHOT_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_SNAPSHOT_H_

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"
#include "frontend/health.h"
#include "frontend/loop_closure/closure_record.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/map/trinary_map.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::view {

// What is plotted over time. Not a number where it is not known.
struct Figures {
  double stamp_s = 0.0;  // of the log
  std::int64_t scans = 0;
  std::int64_t updates = 0;
  backend::SE2 world_T_robot;
  double effective_particles = std::numeric_limits<double>::quiet_NaN();  // N_eff, eq. (17)
  double cost = std::numeric_limits<double>::quiet_NaN();         // of the graph optimized last
  double scans_per_s = std::numeric_limits<double>::quiet_NaN();  // of wall time
  std::int64_t accepted_closures = 0;
  std::int64_t refused_closures = 0;
};

struct ParticleSnapshot {
  backend::SE2 world_T_robot;
  double weight = 0.0;             // of all particles' sum
  std::vector<backend::SE2> tail;  // its last poses, the latest one first
};

// The pose graph without what is not drawn: nodes follow each other, and accepted candidates are
// its closures.
struct GraphSnapshot {
  backend::Trajectory nodes;
  std::vector<loop_closure::ClosureRecord> candidates;
};

struct HealthSnapshot {
  std::map<std::string, frontend::Finding> findings;
  std::map<std::string, std::vector<frontend::Stretch>> stretches;
};

enum class Phase : std::uint8_t {
  kRunning,
  kFinishing,  // all scans are in: the final optimization
  kFinished
};

// What is missing is as it was in the snapshot before.
struct Snapshot {
  Phase phase = Phase::kRunning;
  Figures figures;
  std::vector<Figures> history;  // at the updates since the snapshot before
  bool lost = false;             // of the latest scan
  bool ambiguous = false;
  // False while the robot is not found in an old map: grid, particles and scan are of a piece that
  // may lie anywhere in it, the graph is that of the old map.
  bool placed = true;
  std::vector<ParticleSnapshot> particles;
  int best_particle = 0;
  sensor::LaserScan scan;  // the latest one, not deskewed
  HealthSnapshot health;
  std::shared_ptr<const GraphSnapshot> graph;
  backend::Trajectory trajectory;               // of all scans, once it is final
  std::optional<map::OccupancyGrid> grid;       // shares its tiles with the best particle's
  std::optional<map::TrinaryMap> finished_map;  // in place of it
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_SNAPSHOT_H_
