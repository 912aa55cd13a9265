// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/foxglove_map.h"

#include <gtest/gtest.h>

namespace gmapping_spa::view {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(Base64("\xff\xfe\xfd"), "//79");
}

TEST(FoxgloveMap, IsTheRectangleOfKnownTiles) {
  RunState run(0, {.name = "log", .resolution_m = 0.1});
  Snapshot snapshot;
  snapshot.grid = map::OccupancyGrid({.resolution_m = 0.1});
  snapshot.grid->AddHit(-0.5, 0.5);
  snapshot.grid->AddHit(20.5, 40.5);
  run.Apply(std::move(snapshot));
  const nlohmann::json grid = FoxgloveMap(run);
  EXPECT_EQ(grid["column_count"], 3 * 16);
  EXPECT_EQ(grid["row_stride"], 3 * 16);
  EXPECT_DOUBLE_EQ(grid["pose"]["position"]["x"], -1.6);
  EXPECT_DOUBLE_EQ(grid["pose"]["position"]["y"], 0.0);
  const std::string data = grid["data"];
  EXPECT_EQ(data.size(), (3 * 16 * 3 * 16) / 3 * 4U);
  // The cell at (-1, 0) is byte 15 of the first row, the first one of a group of three.
  EXPECT_EQ(data.substr(16, 8), "////ZP//");
}

TEST(FoxgloveMap, MayBeEmpty) {
  const nlohmann::json grid = FoxgloveMap(RunState(0, {}));
  EXPECT_EQ(grid["column_count"], 0);
  EXPECT_EQ(grid["data"], "");
}

}  // namespace
}  // namespace gmapping_spa::view
