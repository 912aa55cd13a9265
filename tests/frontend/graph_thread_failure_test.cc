// SPDX-License-Identifier: BSD-3-Clause
// What a graph thread does about back ends that fail or hang, and what it reports.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "frontend/graph_thread.h"
#include "tests/frontend/gated_back_end.h"

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::Summary;
using backend::Termination;

std::int64_t CountOf(const Health& health, const char* kind) {
  const auto found = health.findings().find(kind);
  return found == health.findings().end() ? 0 : found->second.count;
}

class GraphThreadFailure : public testing::Test {
 protected:
  Health health_;
};

TEST_F(GraphThreadFailure, FailureCostsOnlyItsResult) {
  int calls = 0;
  GraphThread thread(Lockstep(2), &health_, [&calls](PoseGraph* graph) -> Summary {
    graph->nodes.at(0).world_T_node.x += 1.0;
    switch (++calls) {
      case 1:
        return Ended(Termination::kFailure);
      case 2:
        throw std::runtime_error("out of luck");
      case 3:
        throw 42;
      default:
        return Ended(Termination::kNoConvergence);  // better than nothing
    }
  });
  for (int failures = 1; failures <= 3; ++failures) {
    thread.Start(GraphAt(10));
    EXPECT_FALSE(thread.TakeIfDue(0.0));
    EXPECT_FALSE(thread.TakeIfDue(0.0));
    EXPECT_FALSE(thread.busy());
    EXPECT_EQ(thread.counts().failed, failures);
  }
  thread.Start(GraphAt(10));
  EXPECT_FALSE(thread.TakeIfDue(0.0));
  const std::optional<PoseGraph> taken = thread.TakeIfDue(0.0);
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
  EXPECT_EQ(thread.counts().started, 4);
  EXPECT_EQ(thread.counts().taken, 1);
  EXPECT_EQ(thread.counts().failed, 3);
  EXPECT_EQ(CountOf(health_, "backend_failed"), 3);
  EXPECT_EQ(CountOf(health_, "backend_not_converged"), 1);
}

TEST_F(GraphThreadFailure, GoesOnWithoutABackEndThatHangsAndTakesItsResultWhenItComes) {
  for (const GraphThread::Mode mode : {GraphThread::Mode::kLockstep, GraphThread::Mode::kInline}) {
    const GatedBackEnd backend;
    Health health;
    GraphThread thread({mode, 1, 0.005}, &health, backend.Function());
    thread.Start(GraphAt(10));
    for (int scan = 0; scan < 10; ++scan) EXPECT_FALSE(thread.TakeIfDue(0.0));
    EXPECT_TRUE(thread.busy());
    EXPECT_EQ(thread.counts().late, 1);
    EXPECT_EQ(CountOf(health, "backend_late"), 1);
    backend.Allow();
    const std::optional<PoseGraph> taken = TryUntilTaken(&thread);
    ASSERT_TRUE(taken);
    EXPECT_EQ(XOf(*taken), 11);
    EXPECT_EQ(thread.counts().taken, 1);
    EXPECT_EQ(thread.counts().failed, 0);

    // The next one has its full time again.
    thread.Start(GraphAt(20));
    backend.Allow();
    EXPECT_TRUE(TryUntilTaken(&thread));
  }
}

TEST_F(GraphThreadFailure, WaitsForABackEndThatHangsOnlyOnce) {
  const GatedBackEnd backend;
  GraphThread thread(Lockstep(1, 0.1), &health_, backend.Function());
  thread.Start(GraphAt(10));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(thread.TakeIfDue(0.0));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(100));
  for (int scan = 0; scan < 50; ++scan) EXPECT_FALSE(thread.TakeIfDue(0.0));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  backend.Allow();
}

TEST_F(GraphThreadFailure, FinishGivesUpOnABackEndThatHangs) {
  const GatedBackEnd backend;
  GraphThread thread(Lockstep(100, 0.005), &health_, backend.Function());
  thread.Start(GraphAt(10));
  EXPECT_FALSE(thread.Finish());
  EXPECT_TRUE(thread.busy());
  EXPECT_EQ(thread.counts().taken, 0);
  EXPECT_EQ(thread.counts().failed, 0);
  backend.Allow();
}

TEST_F(GraphThreadFailure, RunGivesNothingWhileTheBackEndHangs) {
  const GatedBackEnd backend;
  GraphThread thread(Lockstep(1, 0.005), &health_, backend.Function());
  thread.Start(GraphAt(10));
  EXPECT_FALSE(thread.Run(GraphAt(20)));
  EXPECT_EQ(thread.counts().started, 1);
  EXPECT_EQ(CountOf(health_, "backend_busy"), 1);
  backend.Allow();
}

TEST_F(GraphThreadFailure, ReportsWithTheStampOfTheLatestScan) {
  GraphThread thread(Lockstep(1), &health_, [](PoseGraph*) { return Summary{}; });
  for (const double stamp_s : {12.5, 13.5}) {
    thread.Start(GraphAt(10));
    EXPECT_FALSE(thread.TakeIfDue(stamp_s));
  }
  EXPECT_FALSE(thread.Run(GraphAt(10)));
  const Finding& failed = health_.findings().at("backend_failed");
  EXPECT_EQ(failed.count, 3);
  EXPECT_EQ(failed.first_stamp_s, 12.5);
  EXPECT_EQ(failed.last_stamp_s, 13.5);
}

TEST_F(GraphThreadFailure, ABackEndThatConvergesIsNothingToReport) {
  const GatedBackEnd backend;
  backend.Allow();
  GraphThread thread(Lockstep(1), &health_, backend.Function());
  thread.Start(GraphAt(10));
  EXPECT_TRUE(thread.TakeIfDue(0.0));
  EXPECT_TRUE(health_.findings().empty());
}

}  // namespace
}  // namespace gmapping_spa::frontend
