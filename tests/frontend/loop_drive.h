// SPDX-License-Identifier: BSD-3-Clause
// ImprovedGmapping on a drive around a loop, with any back end.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LOOP_DRIVE_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LOOP_DRIVE_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/scheduling/optimize_safely.h"
#include "backend/spa/spa_optimizer.h"
#include "frontend/improved_gmapping.h"
#include "frontend/scan_matching/gauss_newton_matcher.h"
#include "tests/frontend/drifting_scans.h"

namespace gmapping_spa::frontend {

// As programs call it.
inline GraphThread::OptimizeFunction Safely(std::shared_ptr<backend::Optimizer> optimizer) {
  return [optimizer](backend::PoseGraph* graph) {
    return backend::OptimizeSafely({}, optimizer.get(), graph);
  };
}

inline GraphThread::OptimizeFunction Spa() { return Safely(std::make_shared<spa::SpaOptimizer>()); }

inline backend::Summary NoBackEnd(backend::PoseGraph*) {
  backend::Summary summary;
  summary.termination = backend::Termination::kConverged;
  return summary;
}

inline std::string TumBytes(const backend::Trajectory& trajectory) {
  std::ostringstream out;
  backend::WriteTum(trajectory, out);
  return out.str();
}

class LoopDrive : public testing::Test {
 protected:
  // One round and a quarter.
  static void SetUpTestSuite() {
    truth_ = synthetic::DriveOnRing(0, 60, 0.25);
    scans_ = synthetic::DriftingScans(truth_);
  }

  static ImprovedGmapping::Options Options() {
    ImprovedGmapping::Options options;
    options.filter.particles = 3;
    options.filter.edges.measurement = particle_filter::EdgeModel::Measurement::kControl;
    options.optimize_every = 10;
    options.graph_thread.timeout_s = 60.0;
    return options;
  }

  static std::unique_ptr<ImprovedGmapping> Drive(const ImprovedGmapping::Options& options,
                                                 GraphThread::OptimizeFunction optimize,
                                                 std::size_t scans = scans_.size()) {
    auto gmapping = std::make_unique<ImprovedGmapping>(
        options,
        std::make_shared<scan_matching::GaussNewtonMatcher>(
            scan_matching::GaussNewtonMatcher::Options{}, options.filter.endpoint),
        std::move(optimize));
    for (std::size_t k = 0; k < scans; ++k) gmapping->AddScan(scans_[k]);
    return gmapping;
  }

  static std::string TrajectoryBytes(const ImprovedGmapping::Options& options,
                                     GraphThread::OptimizeFunction optimize) {
    return TumBytes(Drive(options, std::move(optimize))->Finish().trajectory);
  }

  static const std::string& BytesWithoutABackEnd() {
    static const std::string bytes = TrajectoryBytes(Options(), NoBackEnd);
    return bytes;
  }

  static double LargestError(const backend::Trajectory& trajectory) {
    EXPECT_EQ(trajectory.size(), truth_.size());
    double largest_m = 0.0;
    for (std::size_t k = 0; k < truth_.size(); ++k) {
      const backend::SE2 off =
          Between(Between(truth_[0], truth_[k]), trajectory.at(k).world_T_robot);
      largest_m = std::max(largest_m, off.translation().norm());
    }
    return largest_m;
  }

  inline static std::vector<backend::SE2> truth_;
  inline static std::vector<sensor::LaserScan> scans_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LOOP_DRIVE_H_
