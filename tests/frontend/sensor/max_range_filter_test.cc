// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/max_range_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace gmapping_spa::sensor {
namespace {

// Scans of 100 beams in whole centimeters, up to the laser's maximum, which longer ones are set to.
std::vector<LaserScan> Scans(int count, double maximum_m, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> range_cm(50, 1000);
  std::vector<LaserScan> scans(count);
  for (LaserScan& scan : scans) {
    for (int k = 0; k < 100; ++k) {
      scan.beams.push_back(
          {0.01 * k, std::min(range_cm(random) / 100.0, maximum_m), BeamStatus::kHit});
    }
  }
  return scans;
}

void Learn(const std::vector<LaserScan>& scans, MaxRangeFilter* filter) {
  std::vector<const LaserScan*> pointers;
  for (const LaserScan& scan : scans) pointers.push_back(&scan);
  filter->Learn(pointers);
}

TEST(MaxRangeFilter, TakesTheLongestReadingForNoReturnWhereItOccursAgainAndAgain) {
  std::vector<LaserScan> scans = Scans(200, 8.0);
  MaxRangeFilter filter;
  Learn(scans, &filter);
  for (LaserScan& scan : scans) {
    const LaserScan before = scan;
    std::int64_t expected = 0;
    const std::int64_t changed = filter.Apply(&scan);
    for (std::size_t k = 0; k < scan.beams.size(); ++k) {
      const bool at_maximum = before.beams[k].range_m == 8.0;
      expected += static_cast<std::int64_t>(at_maximum);
      EXPECT_EQ(scan.beams[k].status, at_maximum ? BeamStatus::kNoReturn : BeamStatus::kHit);
      EXPECT_EQ(scan.beams[k].range_m, before.beams[k].range_m);
    }
    EXPECT_EQ(changed, expected);
  }
}

TEST(MaxRangeFilter, LeavesALongestReadingAloneThatOccursByChance) {
  std::vector<LaserScan> scans = Scans(200, 100.0);  // 10.00 m about once in ten scans
  MaxRangeFilter filter;
  Learn(scans, &filter);
  for (LaserScan& scan : scans) EXPECT_EQ(filter.Apply(&scan), 0);
}

TEST(MaxRangeFilter, WantsMoreThanAFewScans) {
  std::vector<LaserScan> scans = Scans(19, 8.0);
  MaxRangeFilter filter;
  Learn(scans, &filter);
  EXPECT_EQ(filter.Apply(&scans[0]), 0);
}

TEST(MaxRangeFilter, GivesUpWhenALongerReadingComes) {
  std::vector<LaserScan> scans = Scans(200, 8.0), later = Scans(200, 100.0, 2);
  MaxRangeFilter filter;
  Learn(scans, &filter);
  ASSERT_GT(filter.Apply(&scans[0]), 0);
  Learn(later, &filter);
  for (LaserScan& scan : scans) EXPECT_EQ(filter.Apply(&scan), 0);
}

TEST(MaxRangeFilter, DoesNotCountBeamsThatSayNothing) {
  std::vector<LaserScan> scans = Scans(200, 8.0);
  for (LaserScan& scan : scans) {
    for (Beam& beam : scan.beams) {
      if (beam.range_m == 8.0) beam.status = BeamStatus::kInvalid;
    }
  }
  MaxRangeFilter filter;
  Learn(scans, &filter);
  for (LaserScan& scan : scans) EXPECT_EQ(filter.Apply(&scan), 0);
}

}  // namespace
}  // namespace gmapping_spa::sensor
