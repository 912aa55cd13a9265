// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/global_closing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "frontend/loop_closure/loop_closer.h"
#include "tests/frontend/loop_closure/far_drive.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;
using synthetic::FarDrive;

// As in a run, with numbers on which the tests rely.
LoopCloser CloseLoops(const FarDrive& drive, bool everywhere = true, double min_span_m = 12.0) {
  LoopCloser::Options options;
  options.global.proof.min_span_m = min_span_m;
  options.drift = {.floor_m = 0.1, .m_per_m = 0.01, .floor_rad = 0.01, .rad_per_m = 0.0005};
  options.search_everywhere = everywhere;
  LoopCloser closer(options);
  for (std::size_t k = 1; k <= drive.estimate.size(); ++k) {
    closer.Update({drive.estimate.begin(), drive.estimate.begin() + k}, drive.scan_of_node);
  }
  closer.UpdateAll(drive.estimate, drive.scan_of_node);
  return closer;
}

// Whether some of it was taken for what it is not, so that there is something to refuse.
bool HasRecognized(const LoopCloser& closer) {
  return std::any_of(closer.records().begin(), closer.records().end(), [](const auto& record) {
    return record.source == Source::kFollowed && record.verdict == Verdict::kUnconfirmed;
  });
}

void ExpectRight(const FarDrive& drive, const std::vector<backend::Edge>& closures) {
  for (const backend::Edge& closure : closures) {
    const SE2 off =
        Between(Between(drive.truth.at(closure.i), drive.truth.at(closure.j)), closure.i_T_j);
    EXPECT_LT(off.translation().norm(), 0.1) << closure.i << ' ' << closure.j;
    EXPECT_LT(std::abs(off.theta), 0.03) << closure.i << ' ' << closure.j;
  }
}

constexpr SE2 kFarOff{50.0, 0.0, 0.21};

TEST(GlobalCloser, FindsALoopThatArrives50mAnd12DegOff) {
  const FarDrive drive(700.0, synthetic::Ring(), 40.0, kFarOff);
  const LoopCloser closer = CloseLoops(drive);
  EXPECT_GE(closer.closures().size(), 8u);
  ExpectRight(drive, closer.closures());
  EXPECT_TRUE(CloseLoops(drive, /*everywhere=*/false).closures().empty());
}

TEST(GlobalCloser, FindsALoopThatArrivesTurnedAround) {
  const FarDrive drive(700.0, synthetic::Ring(), 40.0, {3.0, 2.0, std::numbers::pi});
  const LoopCloser closer = CloseLoops(drive);
  EXPECT_GE(closer.closures().size(), 8u);
  ExpectRight(drive, closer.closures());
}

TEST(GlobalCloser, AWayBackTooShortProvesNothing) {
  const FarDrive drive(700.0, synthetic::Ring(), 14.0, kFarOff);
  const LoopCloser closer = CloseLoops(drive);
  EXPECT_TRUE(closer.closures().empty());
  EXPECT_TRUE(HasRecognized(closer));
}

TEST(GlobalCloser, AWayBackTooShortIsSaidToBeUnproven) {
  const FarDrive drive(700.0, synthetic::Ring(), 14.0, {15.0, 0.0, 0.1});
  const LoopCloser closer = CloseLoops(drive);
  EXPECT_TRUE(closer.closures().empty());
  const std::vector<UnprovenClosure> unproven = closer.Unproven(drive.estimate);
  ASSERT_FALSE(unproven.empty());
  EXPECT_GE(unproven.front().node, drive.first_node_back);
  EXPECT_NEAR(unproven.front().moved_m, 15.0, 2.0);
}

TEST(GlobalCloser, ATwinThatDriftDoesNotExplainIsNotTakenForTheSame) {
  // All of the way back looks the same: only the odometry knows that it was elsewhere.
  const FarDrive drive(100.0, synthetic::Ring(), 40.0, kFarOff);
  const LoopCloser closer = CloseLoops(drive);
  EXPECT_TRUE(closer.closures().empty());
  EXPECT_TRUE(HasRecognized(closer));
}

TEST(GlobalCloser, ATwinOfAPartIsNotTakenForTheSame) {
  const FarDrive drive(700.0, synthetic::TwinOfTheFirstSide(), 24.0, kFarOff);
  const LoopCloser closer = CloseLoops(drive);
  EXPECT_TRUE(closer.closures().empty());
  EXPECT_TRUE(HasRecognized(closer));
}

TEST(GlobalCloser, ASetThatMeetsContradictionsLaterIsReleased) {
  // Believed too early, while the twin still looks the same.
  const FarDrive drive(700.0, synthetic::TwinOfTheFirstSide(), 40.0, kFarOff);
  const LoopCloser closer = CloseLoops(drive, /*everywhere=*/true, /*min_span_m=*/3.0);
  EXPECT_TRUE(closer.closures().empty());
  EXPECT_TRUE(std::any_of(
      closer.records().begin(), closer.records().end(),
      [](const ClosureRecord& record) { return record.verdict == Verdict::kReleased; }));
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
