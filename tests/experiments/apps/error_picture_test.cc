// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/error_picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "tests/experiments/apps/picture.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using map::CellState;
using map::TrinaryMap;

constexpr std::uint32_t kWhite = 0xffffff, kBlack = 0x000000;

// 40 x 20 cells: free, with a wall along the bottom row; unknown on the right.
TrinaryMap World() {
  TrinaryMap map{40, 20, 0.05, -1.0, 2.0, {}};
  map.cells.assign(40 * 20, CellState::kUnknown);
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 30; ++column) {
      map.at(column, row) = row == 0 ? CellState::kOccupied : CellState::kFree;
    }
  }
  return map;
}

class ErrorPicture : public ::testing::Test {
 protected:
  // The error map of `map`, at 20 pixels a cell.
  void Draw(const TrinaryMap& map) {
    const TrinaryMap truth = World();
    const auto seen = metrics::LookAround(truth, {{0.0, {-0.3, 2.6, 0.0}}}, 30.0);
    const std::string path = folder_.Path("errors.png");
    WriteErrorPicture(truth, metrics::CompareMaps(truth, seen, map, {}), 0.1, path);
    picture_ = ReadPicture(path);
  }

  // In the middle of a cell; half a row more is on its upper edge.
  std::uint32_t ColorAt(double column, double row) const {
    return picture_.at(static_cast<int>((column + 0.5) * 20), static_cast<int>((19.5 - row) * 20));
  }

  TemporaryFolder folder_;
  Picture picture_;
};

TEST_F(ErrorPicture, OfTheTruthIsBlackWallsInWhiteSpace) {
  Draw(World());
  EXPECT_EQ(picture_.width, 800);
  EXPECT_GT(picture_.height, 400) << "with a legend";
  EXPECT_EQ(ColorAt(10, 10), kWhite);
  EXPECT_EQ(ColorAt(10, 0.5), kBlack) << "the upper edge of the wall";
  const std::uint32_t unseen = ColorAt(35, 10);
  EXPECT_NE(unseen, kWhite);
  EXPECT_EQ(unseen & 0xff, unseen >> 16) << "grey";
}

TEST_F(ErrorPicture, ShowsWhatIsMissingInBlueAndWhatIsWrongInOrange) {
  TrinaryMap map = World();
  for (int column = 10; column < 20; ++column) map.at(column, 0) = CellState::kFree;
  map.at(5, 15) = CellState::kOccupied;
  Draw(map);
  EXPECT_EQ(ColorAt(5, 0.5), kBlack);
  const std::uint32_t missing = ColorAt(15, 0.5), wrong = ColorAt(5, 15);
  EXPECT_GT(missing & 0xff, missing >> 16) << "more blue than red";
  EXPECT_GT(wrong >> 16, wrong & 0xff) << "more red than blue";
}

TEST_F(ErrorPicture, SaysWhichFileCannotBeWritten) {
  const TrinaryMap truth = World();
  const auto seen = metrics::LookAround(truth, {{0.0, {-0.3, 2.6, 0.0}}}, 30.0);
  const auto comparison = metrics::CompareMaps(truth, seen, truth, {});
  EXPECT_THROW(WriteErrorPicture(truth, comparison, 0.1, "/nowhere/x.png"), std::runtime_error);
  EXPECT_THROW(WriteErrorPicture(truth, comparison, 0.1, "/dev/full"), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::apps
