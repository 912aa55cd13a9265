// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/localization_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "backend/scheduling/optimize_safely.h"
#include "backend/spa/spa_optimizer.h"
#include "frontend/improved_gmapping.h"
#include "frontend/scan_matching/gauss_newton_matcher.h"
#include "tests/frontend/localization/known_hall.h"

namespace gmapping_spa::apps {
namespace {

class LocalizationTable : public testing::Test {
 protected:
  void Drive(const synthetic::Walls& walls, double from_m, double to_m) {
    const std::vector<sensor::LaserScan> scans = synthetic::Driven(walls, from_m, to_m, 0.2);
    for (sensor::LaserScan scan : scans) {
      scan.odom_T_robot = Between(scans.front().odom_T_robot, scan.odom_T_robot);
      gmapping_.AddScan(scan);
    }
  }

  static frontend::ImprovedGmapping::Options Options() {
    frontend::ImprovedGmapping::Options options;
    options.filter.particles = 1;
    options.filter.edges.measurement = particle_filter::EdgeModel::Measurement::kControl;
    return options;
  }

  const std::shared_ptr<spa::SpaOptimizer> spa_ = std::make_shared<spa::SpaOptimizer>();
  frontend::ImprovedGmapping gmapping_{
      Options(),
      std::make_shared<scan_matching::GaussNewtonMatcher>(
          scan_matching::GaussNewtonMatcher::Options{}, Options().filter.endpoint),
      [spa = spa_](backend::PoseGraph* graph) {
        return backend::OptimizeSafely({}, spa.get(), graph);
      }};
};

TEST_F(LocalizationTable, TellsHowSureEachPoseIs) {
  Drive(synthetic::Hall(), 0, 46);
  gmapping_.BeginSession(frontend::MapSession::Use::kLocalize);
  Drive(synthetic::Hall(), 20, 24);
  const frontend::SlamResult result = gmapping_.Finish();
  const std::vector<LocalizedScan> scans = LocalizedScans(gmapping_, result, spa_.get());
  ASSERT_FALSE(scans.empty());
  for (const LocalizedScan& scan : scans) {
    EXPECT_TRUE(scan.is_known);
    EXPECT_GT(scan.covariance(0, 0), 0.0);
    EXPECT_LT(scan.covariance(0, 0), 0.01);
  }
}

// How the piece lies to the map is known next to nothing of, which is no reason to fail.
TEST_F(LocalizationTable, ARobotThatIsNeverFoundIsUnknownAllTheWay) {
  Drive(synthetic::Hall(), 0, 46);
  gmapping_.BeginSession(frontend::MapSession::Use::kLocalize);
  Drive(synthetic::Ring(), 0, 20);
  const frontend::SlamResult result = gmapping_.Finish();
  const std::vector<LocalizedScan> scans = LocalizedScans(gmapping_, result, spa_.get());
  ASSERT_FALSE(scans.empty());
  EXPECT_TRUE(std::none_of(scans.begin(), scans.end(),
                           [](const LocalizedScan& scan) { return scan.is_known; }));
}

}  // namespace
}  // namespace gmapping_spa::apps
