// SPDX-License-Identifier: BSD-3-Clause
// Is gmapping.flags GMapping as its authors published it? Their program, unmodified, with 5
// particles, updates each 1.0 m or 0.5 rad and five seeds on the same logs, is compared with ours,
// in distribution. It took the scans as they come in the file, which matters on intel: by their
// stamps, which jitter, the wheels would go back and forth. A minute: label "long".
#include <cmath>
#include <iterator>

#include "experiments/metrics/statistics.h"
#include "tests/experiments/real_logs.h"

namespace gmapping_spa {
namespace {

class GmappingFlags : public RealLogs {
 protected:
  // Mean relation errors of five seeds.
  std::vector<double> FiveErrors(const std::string& name, const std::string& setting) {
    return Errors(name, setting, 5, {"--particles=5", "--reorder_window_s=0"});
  }
};

// Mann and Whitney's U: the number of pairs in which the first is larger.
int PairsLarger(const std::vector<double>& first, const std::vector<double>& second) {
  int pairs = 0;
  for (const double a : first) {
    for (const double b : second) pairs += a > b;
  }
  return pairs;
}

constexpr double kFiveOfTheOriginalOnIntelM[] = {0.0324, 0.0262, 0.0252, 0.0260, 0.0290};

// Of five against five, U is outside of 3 to 22 with a probability of 3 % if both are alike.
TEST_F(GmappingFlags, OnIntelARankTestDoesNotTellItFromTheOriginal) {
  if (!HaveData("intel")) GTEST_SKIP() << "no real data";
  const std::vector<double> original_m(std::begin(kFiveOfTheOriginalOnIntelM),
                                       std::end(kFiveOfTheOriginalOnIntelM));
  const std::vector<double> ours_m = FiveErrors("intel", "gmapping.flags");
  EXPECT_GE(PairsLarger(ours_m, original_m), 3);
  EXPECT_LE(PairsLarger(ours_m, original_m), 22);
  EXPECT_NEAR(metrics::ComputeStatistics(ours_m).mean, 0.0278, 0.25 * 0.0278);
}

// Of these logs the means over five seeds are known. Student's t of four degrees of freedom is
// within 4.6 with a probability of 99 %.
void ExpectMean(const std::vector<double>& errors_m, double original_mean_m) {
  const metrics::Statistics ours = metrics::ComputeStatistics(errors_m);
  // The standard deviation is that of the population.
  const double standard_error_m = ours.std / std::sqrt(static_cast<double>(errors_m.size()) - 1.0);
  EXPECT_LT(std::abs(ours.mean - original_mean_m), 4.6 * standard_error_m);
  EXPECT_NEAR(ours.mean / original_mean_m, 1.0, 0.25);
}

TEST_F(GmappingFlags, OnAcesTheMeanErrorIsThatOfTheOriginal) {
  if (!HaveData("aces")) GTEST_SKIP() << "no real data";
  ExpectMean(FiveErrors("aces", "gmapping.flags"), 0.0824);
}

// Whose wheels break every filter that skips scans: it runs through and can be scored.
TEST_F(GmappingFlags, OnFr079ItFailsAsTheOriginalDoes) {
  if (!HaveData("fr079")) GTEST_SKIP() << "no real data";
  ExpectMean(FiveErrors("fr079", "gmapping.flags"), 1.66);
  EXPECT_EQ(Score("fr079").used, 1685);
}

}  // namespace
}  // namespace gmapping_spa
