// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map_area.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

constexpr double kResolutionM = 0.05;

sensor::LaserScan ScanWithReach(double range_m) {
  sensor::LaserScan scan;
  scan.index = 17;
  scan.beams.push_back({0.0, range_m, sensor::BeamStatus::kHit});
  return scan;
}

TEST(MapArea, CoversAWholeCampus) {
  MapArea area(kResolutionM);
  for (const SE2 pose : {SE2{}, SE2{250, 0, 1}, SE2{-250, 300, 2}, SE2{0, -300, 3}}) {
    EXPECT_NO_THROW(area.Extend(ScanWithReach(20), pose));
  }
}

TEST(MapArea, NamesTheScanThatLeadsOutOfIt) {
  for (const SE2 pose : {SE2{1000, 1000, 0}, SE2{-1e9, 0, 0}, SE2{0, 1e300, 0},
                         SE2{0, std::numeric_limits<double>::infinity(), 0}}) {
    MapArea area(kResolutionM);
    try {
      area.Extend(ScanWithReach(20), pose);
      FAIL() << pose.x << ' ' << pose.y;
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find("scan 17: "), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos);
    }
  }
}

TEST(MapArea, RefusesPosesThatAreNoNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SE2 pose : {SE2{nan, 0, 0}, SE2{0, nan, 0}}) {
    MapArea area(kResolutionM);
    EXPECT_THROW(area.Extend(ScanWithReach(20), pose), std::runtime_error);
  }
}

TEST(MapArea, RefusesANarrowStripTooLongForItsIndices) {
  MapArea area(kResolutionM);
  EXPECT_THROW(area.Extend(ScanWithReach(0.1), {2e4, 0, 0}), std::runtime_error);
}

TEST(MapArea, IsThatOfAllScansTogether) {
  // Either pose alone makes an area of 450 m x 450 m, both together one of 900 m x 900 m.
  const SE2 one{450, 450, 0}, other{-450, -450, 0};
  EXPECT_NO_THROW(MapArea(kResolutionM).Extend(ScanWithReach(1), one));
  EXPECT_NO_THROW(MapArea(kResolutionM).Extend(ScanWithReach(1), other));
  MapArea area(kResolutionM);
  area.Extend(ScanWithReach(1), one);
  EXPECT_THROW(area.Extend(ScanWithReach(1), other), std::runtime_error);
}

TEST(MapArea, CountsTheReachOfTheBeams) {
  EXPECT_NO_THROW(MapArea(kResolutionM).Extend(ScanWithReach(300), {}));
  EXPECT_THROW(MapArea(kResolutionM).Extend(ScanWithReach(500), {}), std::runtime_error);
}

TEST(MapArea, CoarserCellsCoverMore) {
  EXPECT_THROW(MapArea(0.05).Extend(ScanWithReach(20), {1000, 1000, 0}), std::runtime_error);
  EXPECT_NO_THROW(MapArea(0.5).Extend(ScanWithReach(20), {1000, 1000, 0}));
}

}  // namespace
}  // namespace gmapping_spa::frontend
