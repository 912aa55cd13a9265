// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/closure_findings.h"

#include <gtest/gtest.h>

namespace gmapping_spa::frontend {
namespace {

double Stamp(int node) { return 10.0 * node; }

TEST(ClosureFindings, UnprovenClosuresAreCountedAndTheFirstIsTold) {
  Health health;
  ReportUnprovenClosures({{.node = 7, .moved_m = 31.64}, {.node = 5, .moved_m = 2.0}}, Stamp,
                         &health);
  const Finding& finding = health.findings().at("unproven_closures");
  EXPECT_EQ(finding.count, 2);
  EXPECT_EQ(finding.first_stamp_s, 70.0);
  EXPECT_NE(finding.message.find("31.6 m"), std::string::npos) << finding.message;
}

TEST(ClosureFindings, RejectedClosuresAreCountedAtTheirLaterNode) {
  Health health;
  ReportRejectedClosures({{.i = 3, .j = 9}}, Stamp, &health);
  const Finding& finding = health.findings().at("backend_rejected_closure");
  EXPECT_EQ(finding.count, 1);
  EXPECT_EQ(finding.first_stamp_s, 90.0);
  EXPECT_NE(finding.message.find("nodes 3 and 9"), std::string::npos) << finding.message;
}

TEST(ClosureFindings, NothingToTellIsNothingTold) {
  Health health;
  ReportUnprovenClosures({}, Stamp, &health);
  ReportRejectedClosures({}, Stamp, &health);
  EXPECT_TRUE(health.findings().empty());
}

}  // namespace
}  // namespace gmapping_spa::frontend
