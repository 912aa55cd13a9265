// SPDX-License-Identifier: BSD-3-Clause
// Robots that search for long and must not be found.
#include <gtest/gtest.h>

#include "frontend/localization/localizer.h"
#include "tests/frontend/localization/localize.h"

namespace gmapping_spa::localization {
namespace {

using backend::SE2;

// Two rooms at either end of a passage, alike to the last corner: turned by half a turn about the
// middle of the passage all is the same.
synthetic::Walls TwinRooms() {
  synthetic::Walls walls;
  synthetic::AddPolygon({{-14, -3},
                         {-6, -3},
                         {-6, -1},
                         {6, -1},
                         {6, -3},
                         {13, -3},
                         {14, -1.5},
                         {14, 3},
                         {6, 3},
                         {6, 1},
                         {-6, 1},
                         {-6, 3},
                         {-13, 3},
                         {-14, 1.5}},
                        0.0, &walls);
  return walls;
}

TEST(LocalizerElsewhere, NeverFindsARobotInAnotherBuilding) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  EXPECT_FALSE(Localize(map, synthetic::Driven(synthetic::Ring(), 0.0, 47.0, 0.3)).located);
}

TEST(LocalizerElsewhere, OfTwinRoomsItBelievesNeither) {
  map::OccupancyGrid map({});
  const synthetic::Laser laser{.beams = 360, .field_of_view_rad = 6.2, .usable_range_m = 6.0};
  const auto scan_at = [&](const SE2& pose) { return synthetic::Scan(TwinRooms(), pose, laser); };
  for (double x = -12.0; x <= 12.0; x += 0.25) {
    map::InsertScan(scan_at({x, 0, 0}), {x, 0, 0}, {}, &map);
  }
  Localizer localizer({}, &map);
  for (double x = -11.0; x < 11.0; x += 0.1) {
    EXPECT_FALSE(localizer.AddScan(scan_at({x, 0, 0}), x > -11.0 ? SE2{0.1, 0, 0} : SE2{}).located)
        << x;
  }
}

}  // namespace
}  // namespace gmapping_spa::localization
