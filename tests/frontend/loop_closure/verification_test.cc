// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/verification.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/frontend/loop_closure/aisles.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::loop_closure::verification_test {
namespace {

using backend::SE2;

// A path of two passes through the same or different places. The estimate of the second pass is
// off by a drift; what was scanned is not.
class Verification : public testing::Test {
 protected:
  void Drive(const std::vector<SE2>& first, const std::vector<SE2>& second, const SE2& drift,
             const synthetic::Walls& walls, const synthetic::Laser& laser = {}) {
    truth_ = first;
    truth_.insert(truth_.end(), second.begin(), second.end());
    estimate_ = first;
    for (const SE2& pose : second) estimate_.push_back(drift * pose);
    scans_ = synthetic::ScansAt(truth_, walls, laser);
  }

  // Of `node` after a way of `path_length_m` since `old_node`.
  ClosureRecord Verify(int old_node, int node, double path_length_m,
                       const Verifier::Options& options = {}) const {
    // Not the default drift model, which may be tuned.
    const DriftModel drift{.floor_m = 0.1, .m_per_m = 0.01, .floor_rad = 0.01, .rad_per_m = 0.0005};
    const Verifier verifier(options, drift, CandidateOptions{});
    const double distance_m = Between(estimate_[old_node], estimate_[node]).translation().norm();
    return verifier.Verify(estimate_, [this](int k) { return scans_.at(k); }, node,
                           {old_node, path_length_m, distance_m});
  }

  // Eleven nodes on the first side of the Ring, then eleven that pass 0.3 m beside them, 0.4 m
  // farther on.
  void DriveTwiceThroughTheRing(const SE2& drift) {
    const std::vector<SE2> first = synthetic::DriveOnRing(0, 10, 1.0);
    std::vector<SE2> second = synthetic::DriveOnRing(0.4, 10.4, 1.0);
    for (SE2& pose : second) pose.y += 0.3;
    Drive(first, second, drift, synthetic::Ring());
  }

  std::vector<SE2> truth_, estimate_;
  std::vector<sensor::LaserScan> scans_;
};

// A drift of 0.5 m and 2.3 deg about the place of the second pass.
const SE2 kDrift = SE2{8, 1.5, 0} * SE2{0.4, -0.3, 0.04} * Inverse(SE2{8, 1.5, 0});

TEST_F(Verification, FindsTheRelativePoseInSpiteOfTheDrift) {
  DriveTwiceThroughTheRing(kDrift);
  const int old_node = 5, node = 11 + 5;
  const SE2 truth = Between(truth_[old_node], truth_[node]);
  ASSERT_GT(Between(truth, Between(estimate_[old_node], estimate_[node])).translation().norm(),
            0.4);
  const ClosureRecord record = Verify(old_node, node, 48.0);
  EXPECT_EQ(record.verdict, Verdict::kUnconfirmed) << VerdictName(record.verdict);
  const SE2 off = Between(truth, record.old_T_node);
  EXPECT_LT(off.translation().norm(), 0.02);
  EXPECT_LT(std::abs(off.theta), 0.5 * std::numbers::pi / 180);
  EXPECT_EQ(record.old_node, old_node);
  EXPECT_EQ(record.node, node);
  EXPECT_EQ(record.path_length_m, 48.0);
  EXPECT_GT(record.score, record.runner_up_score);
  EXPECT_GT(record.overlap, 0.5);
  EXPECT_LE(record.overlap, 1.0);
  EXPECT_GT(record.inlier_ratio, 0.6);
  EXPECT_GT(record.mahalanobis_sq, 0.1);
}

TEST_F(Verification, FollowsAPeakToBeyondTheWindow) {
  // After 48 m the window ends 1.74 m from the estimate; the gate lets 2.15 m pass.
  DriveTwiceThroughTheRing(SE2{1.98, 0, 0});
  const SE2 truth = Between(truth_[5], truth_[11 + 5]);
  const ClosureRecord record = Verify(5, 11 + 5, 48.0);
  EXPECT_EQ(record.verdict, Verdict::kUnconfirmed) << VerdictName(record.verdict);
  EXPECT_LT(Between(truth, record.old_T_node).translation().norm(), 0.02);
}

TEST_F(Verification, InformationIsPositiveDefiniteAndNotOverconfident) {
  DriveTwiceThroughTheRing(kDrift);
  const Eigen::Matrix3d information = Verify(5, 11 + 5, 48.0).information;
  EXPECT_TRUE(information == information.transpose());
  EXPECT_EQ(information.llt().info(), Eigen::Success);
  const Eigen::Matrix3d covariance = information.inverse();
  EXPECT_GE(std::sqrt(covariance(0, 0)), 0.01);
  EXPECT_GE(std::sqrt(covariance(1, 1)), 0.01);
  EXPECT_GE(std::sqrt(covariance(2, 2)), 0.002);
  EXPECT_LT(std::sqrt(covariance(0, 0)), 0.1);
  EXPECT_LT(std::sqrt(covariance(2, 2)), 0.02);
}

TEST_F(Verification, RefusesWhatTheUncertaintyDoesNotAllow) {
  DriveTwiceThroughTheRing(kDrift);
  Verifier::Options narrow;
  narrow.max_mahalanobis_sq = 0.5 * Verify(5, 11 + 5, 48.0).mahalanobis_sq;
  EXPECT_EQ(Verify(5, 11 + 5, 48.0, narrow).verdict, Verdict::kMahalanobis);
}

TEST_F(Verification, OptionsDecideTheOtherVerdicts) {
  DriveTwiceThroughTheRing(kDrift);
  const auto verdict = [this](const Verifier::Options& options) {
    return Verify(5, 11 + 5, 48.0, options).verdict;
  };
  Verifier::Options options;
  options.search.min_score = 0.999;
  EXPECT_EQ(verdict(options), Verdict::kNoMatch);
  options = {};
  options.max_runner_up_score = 0.1;
  EXPECT_EQ(verdict(options), Verdict::kAmbiguous);
  options = {};
  options.max_shift_m = 0.0;
  EXPECT_EQ(verdict(options), Verdict::kUnstable);
  options = {};
  options.min_expected_overlap = 1.01;
  EXPECT_EQ(verdict(options), Verdict::kOverlap);
  options = {};
  options.min_overlap = 1.01;
  EXPECT_EQ(verdict(options), Verdict::kOverlap);
  options = {};
  options.min_inlier_ratio = 2.0;
  EXPECT_EQ(verdict(options), Verdict::kInlierRatio);
}

TEST_F(Verification, AfterALongWayTheOldScansAreAskedAsWell) {
  DriveTwiceThroughTheRing(kDrift);
  EXPECT_EQ(Verify(5, 11 + 5, 400.0).verdict, Verdict::kUnconfirmed);
  EXPECT_GT(Verify(5, 11 + 5, 400.0).mutual_inlier_ratio, 0.9);
  Verifier::Options strict;
  strict.min_mutual_inlier_ratio = 1.01;
  EXPECT_EQ(Verify(5, 11 + 5, 400.0, strict).verdict, Verdict::kSeenThrough);
  // Where the estimate is good, it decides.
  EXPECT_EQ(Verify(5, 11 + 5, 48.0, strict).verdict, Verdict::kUnconfirmed);
}

// Whoever walks by hides the building, differently in each scan.
TEST_F(Verification, AmongPeopleAsMuchMustFitAsScansThereFitEachOther) {
  DriveTwiceThroughTheRing(kDrift);
  for (int node = 11; node < 22; ++node) {
    std::vector<sensor::Beam>& beams = scans_[node].beams;
    for (int k = 0; k < static_cast<int>(beams.size()); ++k) {
      if ((k / 6 * 7 + node * 13) % 10 < 3) beams[k].range_m *= 0.35 + 0.1 * ((k / 6 + node) % 4);
    }
  }
  Verifier::Options strict;
  strict.min_inlier_ratio = 1.05 * Verify(5, 11 + 5, 48.0).inlier_ratio;
  const ClosureRecord record = Verify(5, 11 + 5, 48.0, strict);
  EXPECT_EQ(record.verdict, Verdict::kUnconfirmed) << VerdictName(record.verdict);
  EXPECT_LT(Between(Between(truth_[5], truth_[11 + 5]), record.old_T_node).translation().norm(),
            0.03);
  strict.min_inlier_ratio *= 1.3;
  EXPECT_EQ(Verify(5, 11 + 5, 48.0, strict).verdict, Verdict::kInlierRatio);
}

TEST_F(Verification, WhereNewScansFitEachOtherNoLessIsAskedOfThem) {
  DriveTwiceThroughTheRing(kDrift);
  synthetic::Walls refurnished = synthetic::Ring();
  for (int k = 0; k < 12; ++k) {
    const double x = 1.0 + 1.4 * k, y = k % 2 == 0 ? 0.6 : 2.4;
    synthetic::AddPolygon({{x, y}, {x + 0.9, y}, {x + 0.9, y + 0.3}, {x, y + 0.3}}, 0.0,
                          &refurnished);
  }
  const std::vector<sensor::LaserScan> scans = synthetic::ScansAt(truth_, refurnished);
  std::copy(scans.begin() + 11, scans.end(), scans_.begin() + 11);
  Verifier::Options strict;
  strict.min_inlier_ratio = 1.05 * Verify(5, 11 + 5, 48.0).inlier_ratio;
  const ClosureRecord record = Verify(5, 11 + 5, 48.0, strict);
  EXPECT_EQ(record.verdict, Verdict::kInlierRatio) << VerdictName(record.verdict);
}

TEST_F(Verification, ACorridorWithoutFeaturesIsAmbiguous) {
  std::vector<SE2> pass;
  for (int k = 0; k <= 12; ++k) pass.push_back({1.0 * k, 0, 0});
  Drive(pass, pass, {0.5, 0.1, 0}, synthetic::Corridor(0.0), {.usable_range_m = 8.0});
  const ClosureRecord record = Verify(6, 13 + 6, 60.0);
  EXPECT_EQ(record.verdict, Verdict::kAmbiguous) << VerdictName(record.verdict);
  EXPECT_GT(record.runner_up_score, 0.9 * record.score);
}

// A hall on pillars 5 m apart looks the same from bay to bay.
TEST_F(Verification, WhereTheBuildingRepeatsItselfAnEstimateThatFitsIsNotMoved) {
  synthetic::Walls pillars;
  for (int i = -2; i <= 5; ++i) {
    for (int j = -2; j <= 3; ++j) {
      const double x = 5.0 * i + 2.5, y = 5.0 * j + 2.5;
      synthetic::AddPolygon({{x, y}, {x + 0.4, y}, {x + 0.4, y + 0.4}, {x, y + 0.4}}, 0.0,
                            &pillars);
    }
  }
  std::vector<SE2> first, second;
  for (int k = 0; k <= 10; ++k) {
    first.push_back({1.0 * k, 0, 0});
    second.push_back({1.0 * k + 5.0, 0, 0});
  }
  Verifier::Options options;
  options.max_runner_up_score = 1.01;  // else that one may see it, too
  const synthetic::Laser all_round{
      .beams = 361, .field_of_view_rad = 2 * std::numbers::pi, .usable_range_m = 12.0};
  Drive(first, second, {}, pillars, all_round);
  const ClosureRecord right = Verify(5, 11 + 5, 300.0, options);
  // Where a bay less is between them the more is seen in common.
  ASSERT_GT(Between(right.old_T_node, Between(truth_[5], truth_[16])).translation().norm(), 4.0);
  EXPECT_EQ(right.verdict, Verdict::kAmbiguous) << VerdictName(right.verdict);
  // An estimate that fits nowhere is no argument against a place that does.
  Drive(first, second, {1.2, 0.9, 0.0}, pillars, all_round);
  EXPECT_EQ(Verify(5, 11 + 5, 300.0, options).verdict, Verdict::kUnconfirmed);
}

// The estimate has the second pass in an aisle that was not seen before, where nothing speaks for
// it.
TEST_F(Verification, AnAisleOffIsNotBelievedWhereTheNextLooksAlike) {
  std::vector<SE2> first = synthetic::DriveAisle(0, true);
  for (const SE2& pose : synthetic::DriveAisle(1, false)) first.push_back(pose);
  const std::vector<SE2> second = synthetic::DriveAisle(2, true);
  const synthetic::Laser all_round{
      .beams = 361, .field_of_view_rad = 2 * std::numbers::pi, .usable_range_m = 6.0};
  Drive(first, second, {}, synthetic::Racks(0, 3), all_round);
  EXPECT_EQ(Verify(21 + 10, 42 + 10, 200.0).verdict, Verdict::kRival);
  Drive(first, second, {}, synthetic::Racks(1, 3), all_round);
  EXPECT_EQ(Verify(21 + 10, 42 + 10, 200.0).verdict, Verdict::kUnconfirmed);
}

TEST_F(Verification, RefusesAnotherPlaceThatIsTakenForTheOldOne) {
  // The second pass is on another side of the Ring, but the estimate puts it onto the first.
  const std::vector<SE2> first = synthetic::DriveOnRing(0, 10, 1.0);
  for (const double from_m : {14.0, 24.0, 37.0}) {
    const std::vector<SE2> second = synthetic::DriveOnRing(from_m, from_m + 10, 1.0);
    Drive(first, second, first[5] * Inverse(second[5]), synthetic::Ring());
    const ClosureRecord record = Verify(5, 11 + 5, 40.0);
    EXPECT_LT(record.verdict, Verdict::kUnconfirmed) << from_m;
  }
}

TEST_F(Verification, RefusesWhatDoesNotOverlap) {
  // Both passes are estimated where they are, 10 m apart with a block between them.
  Drive(synthetic::DriveOnRing(3, 9, 1.0), synthetic::DriveOnRing(27, 33, 1.0), {},
        synthetic::Ring());
  EXPECT_EQ(Verify(3, 7 + 3, 24.0).verdict, Verdict::kOverlap);
}

TEST_F(Verification, RefusesBlindScans) {
  DriveTwiceThroughTheRing(kDrift);
  for (sensor::LaserScan& scan : scans_) scan.beams.clear();
  EXPECT_EQ(Verify(5, 11 + 5, 20.0).verdict, Verdict::kOverlap);
  // After a long way, when the window is large and the overlap expected says nothing.
  EXPECT_EQ(Verify(5, 11 + 5, 500.0).verdict, Verdict::kNoMatch);
}

}  // namespace
}  // namespace gmapping_spa::loop_closure::verification_test
