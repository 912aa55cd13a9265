// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/closure_record.h"

#include <gtest/gtest.h>

#include <string>

namespace gmapping_spa::loop_closure {
namespace {

// The names are part of loop_closures.csv and run.json: programs read them.
TEST(VerdictName, IsWhatTheFilesSay) {
  EXPECT_STREQ(VerdictName(Verdict::kNoMatch), "no_match");
  EXPECT_STREQ(VerdictName(Verdict::kAmbiguous), "ambiguous");
  EXPECT_STREQ(VerdictName(Verdict::kUnstable), "unstable");
  EXPECT_STREQ(VerdictName(Verdict::kOverlap), "overlap");
  EXPECT_STREQ(VerdictName(Verdict::kInlierRatio), "inlier_ratio");
  EXPECT_STREQ(VerdictName(Verdict::kSeenThrough), "seen_through");
  EXPECT_STREQ(VerdictName(Verdict::kMahalanobis), "mahalanobis");
  EXPECT_STREQ(VerdictName(Verdict::kRival), "rival");
  EXPECT_STREQ(VerdictName(Verdict::kUnconfirmed), "unconfirmed");
  EXPECT_STREQ(VerdictName(Verdict::kReleased), "released");
  EXPECT_STREQ(VerdictName(Verdict::kRejected), "rejected");
  EXPECT_STREQ(VerdictName(Verdict::kAccepted), "accepted");
}

TEST(VerdictName, IsReadBack) {
  EXPECT_EQ(VerdictNamed("released"), Verdict::kReleased);
  EXPECT_EQ(VerdictNamed("release"), std::nullopt);
  EXPECT_EQ(SourceNamed("hand"), Source::kHand);
}

TEST(VerdictName, OfNoVerdictIsUnknown) {
  EXPECT_STREQ(VerdictName(static_cast<Verdict>(200)), "unknown");
}

TEST(SourceName, IsWhatTheTableSays) {
  EXPECT_STREQ(SourceName(Source::kNear), "near");
  EXPECT_STREQ(SourceName(Source::kPlace), "place");
  EXPECT_STREQ(SourceName(Source::kFollowed), "followed");
  EXPECT_STREQ(SourceName(Source::kHand), "hand");
  EXPECT_STREQ(SourceName(static_cast<Source>(200)), "unknown");
}

TEST(ClosureRecord, StartsAsNoMatch) { EXPECT_EQ(ClosureRecord{}.verdict, Verdict::kNoMatch); }

}  // namespace
}  // namespace gmapping_spa::loop_closure
