// SPDX-License-Identifier: BSD-3-Clause
// Who wants to see how a run of SLAM goes.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_SLAM_OBSERVER_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_SLAM_OBSERVER_H_

#include "frontend/api/scan_result.h"
#include "frontend/improved_gmapping.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/slam_result.h"

namespace gmapping_spa::view {

// Called in the thread of the run, which goes on when a call returns.
class SlamObserver {
 public:
  virtual ~SlamObserver() = default;
  virtual void AfterScan(const frontend::ImprovedGmapping& gmapping, const sensor::LaserScan& scan,
                         const ScanResult& result) = 0;
  // All scans are in; what is left is the final optimization.
  virtual void BeforeFinish() = 0;
  virtual void AfterFinish(const frontend::ImprovedGmapping& gmapping,
                           const frontend::SlamResult& result) = 0;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_SLAM_OBSERVER_H_
