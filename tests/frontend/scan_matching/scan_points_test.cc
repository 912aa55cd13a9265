// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/scan_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::scan_matching {
namespace {

using sensor::BeamStatus;

constexpr double kQuarterTurn = std::numbers::pi / 2;

TEST(MakeScanPoints, KeepsTheHitsInTheirOrder) {
  sensor::LaserScan scan;
  scan.beams = {{0.0, 1.0, BeamStatus::kHit},
                {0.0, 9.0, BeamStatus::kNoReturn},
                {0.0, 0.0, BeamStatus::kInvalid},
                {0.0, 2.0, BeamStatus::kHit}};
  const ScanPoints points = MakeScanPoints(scan);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].x_m, 1.0);
  EXPECT_EQ(points[1].x_m, 2.0);
}

TEST(MakeScanPoints, BeamsThatEndCloseTogetherCountLess) {
  sensor::LaserScan scan;
  for (int i = 0; i < 5; ++i) scan.beams.push_back({0.02 * i, 1.0 + i, BeamStatus::kHit});
  scan.beams.push_back({0.1, 0.2, BeamStatus::kHit});
  scan.beams.push_back({0.12, 30.0, BeamStatus::kHit});
  const ScanPoints points = MakeScanPoints(scan);
  ASSERT_EQ(points.size(), 7u);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(points[i].weight, 0.2 * (1.0 + i), 1e-12) << i;
  EXPECT_EQ(points[5].weight, 0.1);  // a covered laser must be seen to be one
  EXPECT_EQ(points[6].weight, 1.0);
}

TEST(MakeScanPoints, AreInTheRobotFrameAndPointBackToTheLaser) {
  sensor::LaserScan scan;
  scan.odom_T_robot = {100, 200, 1};  // must not matter
  scan.robot_T_laser = {0.3, -0.1, kQuarterTurn};
  scan.beams = {{0.0, 2.0, BeamStatus::kHit}, {kQuarterTurn, 3.0, BeamStatus::kHit}};
  const ScanPoints points = MakeScanPoints(scan);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(points[0].x_m, 0.3, 1e-12);
  EXPECT_NEAR(points[0].y_m, 1.9, 1e-12);
  EXPECT_NEAR(points[0].back_x, 0.0, 1e-12);
  EXPECT_NEAR(points[0].back_y, -1.0, 1e-12);
  EXPECT_NEAR(points[1].x_m, -2.7, 1e-12);
  EXPECT_NEAR(points[1].y_m, -0.1, 1e-12);
  EXPECT_NEAR(points[1].back_x, 1.0, 1e-12);
  EXPECT_NEAR(points[1].back_y, 0.0, 1e-12);
}

TEST(MakeEndPoints, AreTheScanPointsWithoutNormals) {
  sensor::LaserScan scan;
  scan.robot_T_laser = {0.3, -0.1, 0.2};
  for (int k = 0; k < 20; ++k) {
    scan.beams.push_back({0.02 * k, 2.0, k == 7 ? BeamStatus::kInvalid : BeamStatus::kHit});
  }
  const ScanPoints points = MakeScanPoints(scan), ends = MakeEndPoints(scan);
  ASSERT_EQ(ends.size(), points.size());
  for (std::size_t k = 0; k < ends.size(); ++k) {
    EXPECT_EQ(ends[k].x_m, points[k].x_m);
    EXPECT_EQ(ends[k].y_m, points[k].y_m);
    EXPECT_EQ(ends[k].back_x, points[k].back_x);
    EXPECT_EQ(ends[k].back_y, points[k].back_y);
    EXPECT_EQ(ends[k].range_m, points[k].range_m);
    EXPECT_EQ(ends[k].normal_x, 0.0);
    EXPECT_EQ(ends[k].normal_y, 0.0);
    EXPECT_NE(points[k].normal_x, 0.0);
  }
}

TEST(MakeScanPoints, OfAScanWithoutHitsAreNone) {
  sensor::LaserScan scan;
  scan.beams = {{0.0, 9.0, BeamStatus::kNoReturn}};
  EXPECT_TRUE(MakeScanPoints(scan).empty());
}

TEST(MakeScanPoints, KnowTheirRange) {
  sensor::LaserScan scan;
  scan.robot_T_laser = {5, 5, 1};
  scan.beams = {{0.3, 2.5, BeamStatus::kHit}};
  EXPECT_EQ(MakeScanPoints(scan).front().range_m, 2.5);
}

constexpr double kBeamStep = std::numbers::pi / 180.0;

// A degree between beams, all of them hits.
sensor::LaserScan ScanOf(double first_rad, const std::vector<double>& ranges_m) {
  sensor::LaserScan scan;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    scan.beams.push_back(
        {first_rad + kBeamStep * static_cast<double>(i), ranges_m[i], BeamStatus::kHit});
  }
  return scan;
}

// Of a wall that is `distance_m` away in the direction `normal_rad`, over a range of beams.
std::vector<double> RangesOfWall(double distance_m, double normal_rad, double first_rad,
                                 int beams) {
  std::vector<double> ranges_m;
  for (int i = 0; i < beams; ++i) {
    ranges_m.push_back(distance_m / std::cos(first_rad + kBeamStep * i - normal_rad));
  }
  return ranges_m;
}

bool HasNormal(const ScanPoint& point) { return std::hypot(point.normal_x, point.normal_y) > 0.5; }

TEST(Normals, OfAWallAreThoseOfTheWallInTheRobotFrame) {
  for (const double normal_rad : {0.0, 0.4, -0.9}) {
    sensor::LaserScan scan = ScanOf(-0.3, RangesOfWall(2.0, normal_rad, -0.3, 35));
    scan.robot_T_laser = {1, 2, 0.5};
    for (const ScanPoint& point : MakeScanPoints(scan)) {
      const double along = std::cos(normal_rad + 0.5), across = std::sin(normal_rad + 0.5);
      EXPECT_NEAR(std::abs(point.normal_x * along + point.normal_y * across), 1.0, 1e-9);
      EXPECT_NEAR(std::hypot(point.normal_x, point.normal_y), 1.0, 1e-9);
    }
  }
}

TEST(Normals, OfALonePointAreNone) {
  const ScanPoint point = MakeScanPoints(ScanOf(0.0, {2.0})).front();
  EXPECT_EQ(point.normal_x, 0.0);
  EXPECT_EQ(point.normal_y, 0.0);
}

TEST(Normals, AreNoneAtACorner) {
  // Walls at x = 2 m and y = 2 m, which meet at 45 degrees.
  std::vector<double> ranges_m = RangesOfWall(2.0, 0.0, 30 * kBeamStep, 15);
  const std::vector<double> rest_m = RangesOfWall(2.0, kQuarterTurn, 45 * kBeamStep, 16);
  ranges_m.insert(ranges_m.end(), rest_m.begin(), rest_m.end());
  const ScanPoints points = MakeScanPoints(ScanOf(30 * kBeamStep, ranges_m));
  EXPECT_FALSE(HasNormal(points[15]));
  EXPECT_NEAR(std::abs(points[5].normal_x), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(points[25].normal_y), 1.0, 1e-9);
}

TEST(Normals, DoNotReachOverAnEdge) {
  // A wall that ends 1 m before another: at the edge the normal is that of the near or far wall,
  // not that of the step between them.
  std::vector<double> ranges_m = RangesOfWall(2.0, 0.0, -20 * kBeamStep, 20);
  const std::vector<double> far_m = RangesOfWall(3.0, 0.0, 0.0, 21);
  ranges_m.insert(ranges_m.end(), far_m.begin(), far_m.end());
  for (const ScanPoint& point : MakeScanPoints(ScanOf(-20 * kBeamStep, ranges_m))) {
    EXPECT_NEAR(std::abs(point.normal_x), 1.0, 1e-9) << point.y_m;
  }
}

TEST(Normals, NeedBeamsThatAreNeighbors) {
  // Every second beam has no return: what is between the hits nobody knows.
  sensor::LaserScan scan = ScanOf(-0.3, RangesOfWall(2.0, 0.0, -0.3, 35));
  for (std::size_t i = 1; i < scan.beams.size(); i += 2) {
    scan.beams[i].status = BeamStatus::kNoReturn;
  }
  for (const ScanPoint& point : MakeScanPoints(scan)) EXPECT_FALSE(HasNormal(point));
}

TEST(Normals, AreNoneWhereAWallIsMetTooFlat) {
  // 80 degrees off the normal: neighboring end points are six times as far apart as across.
  const double first_rad = 80 * kBeamStep;
  for (const ScanPoint& point :
       MakeScanPoints(ScanOf(first_rad, RangesOfWall(1.0, 0.0, first_rad, 6)))) {
    EXPECT_FALSE(HasNormal(point));
  }
}

TEST(Normals, VarianceIsThatOfNoisyRanges) {
  backend::CounterRandom random(9, 0);
  for (const double normal_rad : {0.0, 0.6}) {
    const std::vector<double> exact_m = RangesOfWall(2.0, normal_rad, -0.2, 24);
    double said = 0.0, happened = 0.0;
    int count = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      std::vector<double> ranges_m = exact_m;
      for (double& range_m : ranges_m) range_m += 0.015 * random.Gaussian();
      const ScanPoint point = MakeScanPoints(ScanOf(-0.2, ranges_m))[12];
      if (!HasNormal(point)) continue;
      const double turned =
          std::cos(normal_rad) * point.normal_y - std::sin(normal_rad) * point.normal_x;
      said += point.normal_variance;
      happened += turned * turned;
      ++count;
    }
    ASSERT_GT(count, 1000);
    EXPECT_NEAR(said / happened, 1.0, 0.2) << normal_rad;
  }
}

TEST(Normals, AreSurerTheMoreOfAWallIsInReach) {
  // A near wall has many beams in reach, a far one the neighbors only, which lie farther apart.
  const auto variance = [](double distance_m) {
    return MakeScanPoints(ScanOf(-0.2, RangesOfWall(distance_m, 0.0, -0.2, 24)))[12]
        .normal_variance;
  };
  EXPECT_GT(variance(1.0), 0.0);
  EXPECT_LT(variance(20.0), 0.5 * variance(5.0));
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
