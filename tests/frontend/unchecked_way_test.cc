// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/unchecked_way.h"

#include <gtest/gtest.h>

namespace gmapping_spa::frontend {
namespace {

// Of so many meters, each driven in ten steps; every `checked`-th meter has a check, 0: none.
int Stretches(int meters, int checked) {
  UncheckedWay way;
  int count = 0;
  for (int step = 0; step < 10 * meters; ++step) {
    const bool is_checked = checked > 0 && step / 10 % checked == 0;
    count += way.Add(0.1001, !is_checked) ? 1 : 0;
  }
  return count;
}

TEST(UncheckedWay, IsToldOnceIn10Meters) {
  EXPECT_EQ(Stretches(9, 0), 0);
  EXPECT_EQ(Stretches(35, 0), 3);
}

TEST(UncheckedWay, DoorsThatGoByNowAndThenAreNotEnough) { EXPECT_EQ(Stretches(35, 5), 3); }

TEST(UncheckedWay, IsNoneWhereEverySecondMeterHasACheck) { EXPECT_EQ(Stretches(35, 2), 0); }

}  // namespace
}  // namespace gmapping_spa::frontend
