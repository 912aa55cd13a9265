// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/scan_archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gmapping_spa::sensor {
namespace {

const Eigen::Vector3d kStill = Eigen::Vector3d::Zero();

LaserScan ScanWith(const std::vector<Beam>& beams, std::int64_t index = 0) {
  return {index, 1.0 + static_cast<double>(index), {1, 2, 3}, {0.1, 0.2, 0.3}, beams};
}

// A scan of hits at the same angles, `offset_rad` aside.
LaserScan Fan(int beams, double offset_rad, double range_m) {
  LaserScan scan;
  for (int k = 0; k < beams; ++k) {
    scan.beams.push_back({offset_rad + 0.01 * k, range_m + 0.25 * k, BeamStatus::kHit});
  }
  return scan;
}

// Of what a float can hold.
void ExpectSame(const LaserScan& a, const LaserScan& b) {
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.stamp_s, b.stamp_s);
  EXPECT_TRUE(a.odom_T_robot == b.odom_T_robot);
  EXPECT_TRUE(a.robot_T_laser == b.robot_T_laser);
  ASSERT_EQ(a.beams.size(), b.beams.size());
  for (std::size_t k = 0; k < a.beams.size(); ++k) {
    EXPECT_EQ(a.beams[k].angle_rad, b.beams[k].angle_rad) << k;
    EXPECT_EQ(a.beams[k].range_m, b.beams[k].range_m) << k;
    EXPECT_EQ(a.beams[k].status, b.beams[k].status) << k;
  }
}

TEST(ScanArchive, GivesBackHitsMissingReturnsAndInvalidBeams) {
  const LaserScan scan = ScanWith({{-0.1, 2.5, BeamStatus::kHit},
                                   {0.0, 20.0, BeamStatus::kNoReturn},
                                   {0.1, 0.0, BeamStatus::kInvalid},
                                   {0.30000000000000004, 0.125, BeamStatus::kHit}},
                                  7);
  ScanArchive archive;
  EXPECT_EQ(archive.Add(scan, kStill), 0);
  ExpectSame(archive.Get(0), scan);
  EXPECT_EQ(archive.StampOf(0), 8.0);
}

TEST(ScanArchive, RoundsRangesToFloatAndNothingElse) {
  const double third = 1.0 / 3.0;
  std::vector<Beam> beams;
  for (int k = 0; k < 1000; ++k) {
    beams.push_back({third * k, 0.04 * third * (3 * k + 1),
                     k % 2 == 0 ? BeamStatus::kHit : BeamStatus::kNoReturn});
  }
  LaserScan scan = ScanWith(beams);
  scan.stamp_s = 1e9 + third;
  scan.odom_T_robot = {1e4 + third, -third, third};
  scan.robot_T_laser = {third, -third, third};
  ScanArchive archive;
  archive.Add(scan, kStill);
  for (std::size_t k = 0; k < beams.size(); ++k) {
    EXPECT_LE(std::abs(archive.Get(0).beams[k].range_m - beams[k].range_m), 2e-6) << k;
    EXPECT_EQ(archive.Get(0).beams[k].range_m, static_cast<float>(beams[k].range_m)) << k;
    scan.beams[k].range_m = static_cast<float>(beams[k].range_m);
  }
  ExpectSame(archive.Get(0), scan);
}

TEST(ScanArchive, ScansKeepTheirOwnAnglesWhereThoseChange) {
  const std::vector<LaserScan> scans = {
      Fan(5, 0.0, 1.0),   Fan(5, 0.0, 2.0),                              // the same angles twice
      Fan(5, 0.1, 3.0),                                                  // others
      Fan(5, 0.0, 4.0),                                                  // the first ones again
      Fan(4, 0.0, 5.0),   Fan(6, 0.0, 6.0), Fan(0, 0, 0), Fan(0, 0, 0),  // a different number
      Fan(5, 1e-17, 7.0), Fan(5, 0.0, 8.0)};                             // all but the same
  ScanArchive archive;
  for (std::size_t i = 0; i < scans.size(); ++i) EXPECT_EQ(archive.Add(scans[i], kStill), int(i));
  EXPECT_EQ(archive.size(), static_cast<int>(scans.size()));
  for (std::size_t i = 0; i < scans.size(); ++i) ExpectSame(archive.Get(int(i)), scans[i]);
}

TEST(ScanArchive, EmptyArchiveHoldsNoScan) {
  const ScanArchive archive;
  EXPECT_EQ(archive.size(), 0);
  EXPECT_THROW(archive.Get(0), std::out_of_range);
}

TEST(ScanArchive, DeskewsAllScansOnceTheDurationOfASweepIsKnown) {
  ScanArchive archive;
  const LaserScan scan = Fan(5, 0.0, 2.0);
  archive.Add(scan, {0.0, 0.0, 1.0});
  archive.Add(scan, {0.0, 0.0, 2.0});
  ExpectSame(archive.Get(0), scan);
  archive.set_sweep_s(0.1);
  // Half of the first sweep was at the velocity up to the next scan.
  EXPECT_NEAR(archive.Get(0).beams[0].angle_rad, scan.beams[0].angle_rad - 0.075, 1e-9);
  EXPECT_NEAR(archive.Get(1).beams[0].angle_rad, scan.beams[0].angle_rad - 0.1, 1e-9);
  EXPECT_NEAR(archive.Get(1).beams[4].angle_rad, scan.beams[4].angle_rad + 0.1, 1e-9);
  EXPECT_NEAR(archive.Get(1).beams[2].angle_rad, scan.beams[2].angle_rad, 1e-9);
}

TEST(ScanArchive, ScansOfASessionBeforeKeepItsSweepAndItsVelocity) {
  ScanArchive archive;
  const Eigen::Vector3d turning(0, 0, 1.0), fast(0, 0, 4.0);
  archive.Add(Fan(5, 0.0, 2.0), turning);
  archive.set_sweep_s(0.1);
  const LaserScan of_before = archive.Get(0);
  archive.BeginSession();
  archive.Add(Fan(5, 0.0, 2.0), fast);
  archive.set_sweep_s(0.5);
  ExpectSame(archive.Get(0), of_before);
  EXPECT_GT(std::abs(archive.Get(1).beams[0].angle_rad - archive.Get(0).beams[0].angle_rad), 0.5);
}

}  // namespace
}  // namespace gmapping_spa::sensor
