// SPDX-License-Identifier: BSD-3-Clause
// Snapshots of a run of SLAM: what its own thread has to do for the view.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_SLAM_SNAPSHOT_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_SLAM_SNAPSHOT_H_

#include <memory>

#include "backend/graph/trajectory_io.h"
#include "experiments/view/snapshot.h"
#include "frontend/api/scan_result.h"
#include "frontend/improved_gmapping.h"
#include "frontend/slam_result.h"

namespace gmapping_spa::view {

// Of the latest scan, but for scans_per_s.
Figures FiguresOf(const frontend::ImprovedGmapping& gmapping, double stamp_s,
                  const backend::SE2& world_T_robot);

// Without the graph. Costs a pointer a tile, and what particles and findings are.
Snapshot SnapshotOf(const frontend::ImprovedGmapping& gmapping, const sensor::LaserScan& scan,
                    const ScanResult& result);

// In the order of time, which that of a log need not be.
backend::Trajectory ByTime(backend::Trajectory trajectory);

// In time of the number of nodes and candidates.
std::shared_ptr<const GraphSnapshot> GraphOf(const frontend::ImprovedGmapping& gmapping);

// After the last scan.
Snapshot SnapshotOf(const frontend::ImprovedGmapping& gmapping, const frontend::SlamResult& result);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_SLAM_SNAPSHOT_H_
