// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/figure_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gmapping_spa::view {
namespace {

using ::testing::SizeIs;

void AddStamps(int begin, int end, FigureHistory* history) {
  for (int i = begin; i < end; ++i) {
    Figures figures;
    figures.stamp_s = i;
    history->Add(figures);
  }
}

TEST(FigureHistory, KeepsEverythingUntilItIsFull) {
  FigureHistory history(100);
  AddStamps(0, 100, &history);
  ASSERT_THAT(history.Rows(), SizeIs(100));
  EXPECT_EQ(history.Rows()[99].stamp_s, 99);
}

TEST(FigureHistory, StaysBoundedEvenlyAndCoversTheWholeTime) {
  FigureHistory history(100);
  for (int end = 101; end < 3000; ++end) {
    AddStamps(end == 101 ? 0 : end - 1, end, &history);
    const std::vector<Figures> rows = history.Rows();
    ASSERT_LE(rows.size(), 100U);
    ASSERT_GE(rows.size(), 50U);
    const double step = rows[1].stamp_s - rows[0].stamp_s;
    EXPECT_EQ(rows[0].stamp_s, 0);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i].stamp_s - rows[i - 1].stamp_s, step) << end;
    }
    ASSERT_GT(rows.back().stamp_s + step, end - 1);
  }
}

}  // namespace
}  // namespace gmapping_spa::view
