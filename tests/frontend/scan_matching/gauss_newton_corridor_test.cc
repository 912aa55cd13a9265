// Matching where a direction is left open.
#include <gtest/gtest.h>

#include <cmath>

#include "frontend/scan_matching/gauss_newton.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

// Whichever way it runs.
class GaussNewtonInCorridor : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Direction, GaussNewtonInCorridor, testing::Values(0.0, 0.35, 1.57, -0.8));

TEST_P(GaussNewtonInCorridor, InformationIsLongAcrossAndShortAlong) {
  const double direction_rad = GetParam();
  const map::OccupancyGrid grid = synthetic::CorridorMap(direction_rad);
  const SE2 pose{0.1, -0.2, direction_rad};
  const ScanPoints points =
      MakeScanPoints(synthetic::Scan(synthetic::Corridor(direction_rad), pose));
  const Eigen::Matrix3d information = GaussNewton({}, {}).InformationAt(grid, points, pose);
  const Eigen::Vector2d along(std::cos(direction_rad), std::sin(direction_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Matrix2d xy = information.topLeftCorner<2, 2>();
  // Each beam measures the distance to its wall with the noise of an end point.
  const double expected = static_cast<double>(points.size()) / (0.02 * 0.02);
  EXPECT_NEAR(across.dot(xy * across), expected, 0.02 * expected);
  EXPECT_LT(along.dot(xy * along), 0.005 * expected);
  EXPECT_LT(std::abs(along.dot(xy * across)), 0.02 * expected);
}

TEST_P(GaussNewtonInCorridor, ScanIsMovedAcrossAndLeftWhereItIsAlong) {
  const double direction_rad = GetParam();
  const map::OccupancyGrid grid = synthetic::CorridorMap(direction_rad);
  const SE2 heading{0, 0, direction_rad}, truth = heading * SE2{0.4, 0.1, 0};
  const ScanPoints points =
      MakeScanPoints(synthetic::Scan(synthetic::Corridor(direction_rad), truth));
  const SE2 start = truth * SE2{0.2, 0.04, 0.02};
  for (const double prior : {1e-3, 1e4}) {
    const SE2 aligned = GaussNewton({}, {})
                            .Align(grid, points, start, prior * Eigen::Matrix3d::Identity())
                            .world_T_robot;
    const SE2 error = Between(truth, aligned);
    EXPECT_NEAR(error.x, 0.2, 0.02);
    EXPECT_NEAR(error.y, 0.0, 0.002);
    EXPECT_NEAR(error.theta, 0.0, 0.001);
  }
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
