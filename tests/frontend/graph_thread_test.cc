// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/graph_thread.h"

#include <gtest/gtest.h>

#include <optional>
#include <semaphore>
#include <thread>

#include "tests/frontend/gated_back_end.h"

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::Summary;
using backend::Termination;

class GraphThreadTest : public testing::Test {
 protected:
  Health health_;
};

TEST_F(GraphThreadTest, LockstepTakesTheResultAtTheNthScanThoughItWasThereBefore) {
  std::binary_semaphore done{0};
  GraphThread thread(Lockstep(5), &health_, [&done](PoseGraph* graph) {
    graph->nodes.at(0).world_T_node.x += 1.0;
    done.release();
    return Ended(Termination::kConverged);
  });
  thread.Start(GraphAt(10));
  done.acquire();
  for (int scan = 1; scan < 5; ++scan) {
    EXPECT_FALSE(thread.TakeIfDue(0.0)) << scan;
    EXPECT_TRUE(thread.busy());
  }
  const std::optional<PoseGraph> taken = thread.TakeIfDue(0.0);
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
  EXPECT_FALSE(thread.busy());
  EXPECT_FALSE(thread.TakeIfDue(0.0));
}

TEST_F(GraphThreadTest, LockstepWaitsAtTheNthScanForASlowBackEnd) {
  const GatedBackEnd backend;
  GraphThread thread(Lockstep(3), &health_, backend.Function());
  thread.Start(GraphAt(10));
  EXPECT_FALSE(thread.TakeIfDue(0.0));
  EXPECT_FALSE(thread.TakeIfDue(0.0));
  const std::jthread allow([&backend] { backend.Allow(); });
  const std::optional<PoseGraph> taken = thread.TakeIfDue(0.0);
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
  EXPECT_EQ(thread.counts().late, 0);
}

TEST_F(GraphThreadTest, LockstepCountsFromTheLatestStart) {
  const GatedBackEnd backend;
  backend.Allow(3);
  GraphThread thread(Lockstep(2), &health_, backend.Function());
  for (int round = 0; round < 3; ++round) {
    EXPECT_FALSE(thread.TakeIfDue(0.0)) << "nothing was started";
    thread.Start(GraphAt(round));
    EXPECT_FALSE(thread.TakeIfDue(0.0));
    const std::optional<PoseGraph> taken = thread.TakeIfDue(0.0);
    ASSERT_TRUE(taken);
    EXPECT_EQ(XOf(*taken), round + 1);
  }
  EXPECT_EQ(thread.counts().started, 3);
  EXPECT_EQ(thread.counts().taken, 3);
}

TEST_F(GraphThreadTest, InlineWaitsAtTheNextScan) {
  const GatedBackEnd backend;
  GraphThread thread({GraphThread::Mode::kInline, 10, 60.0}, &health_, backend.Function());
  thread.Start(GraphAt(10));
  const std::jthread allow([&backend] { backend.Allow(); });
  const std::optional<PoseGraph> taken = thread.TakeIfDue(0.0);
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
}

TEST_F(GraphThreadTest, AsyncDoesNotWaitAndTakesTheResultWhenItIsThere) {
  const GatedBackEnd backend;
  GraphThread thread({GraphThread::Mode::kAsync, 2, 60.0}, &health_, backend.Function());
  thread.Start(GraphAt(10));
  for (int scan = 0; scan < 20; ++scan) EXPECT_FALSE(thread.TakeIfDue(0.0));
  EXPECT_TRUE(thread.busy());
  backend.Allow();
  const std::optional<PoseGraph> taken = TryUntilTaken(&thread);
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
  EXPECT_EQ(thread.counts().late, 0);
}

TEST_F(GraphThreadTest, TimeoutOfZeroTakesWhatIsThere) {
  for (const GraphThread::Mode mode :
       {GraphThread::Mode::kLockstep, GraphThread::Mode::kInline, GraphThread::Mode::kAsync}) {
    const GatedBackEnd backend;
    backend.Allow();
    GraphThread thread({mode, 2, 0.0}, &health_, backend.Function());
    thread.Start(GraphAt(10));
    EXPECT_TRUE(TryUntilTaken(&thread)) << static_cast<int>(mode);
  }
}

TEST_F(GraphThreadTest, FinishTakesWhatRunsBeforeItIsDue) {
  const GatedBackEnd backend;
  backend.Allow();
  GraphThread thread(Lockstep(100), &health_, backend.Function());
  EXPECT_FALSE(thread.Finish()) << "nothing was started";
  thread.Start(GraphAt(10));
  const std::optional<PoseGraph> taken = thread.Finish();
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
  EXPECT_FALSE(thread.Finish());
}

TEST_F(GraphThreadTest, RunWaitsForTheResult) {
  const GatedBackEnd backend;
  backend.Allow(2);
  GraphThread thread(Lockstep(100), &health_, backend.Function());
  for (int run = 0; run < 2; ++run) {
    const std::optional<PoseGraph> optimized = thread.Run(GraphAt(run));
    ASSERT_TRUE(optimized);
    EXPECT_EQ(XOf(*optimized), run + 1);
    EXPECT_FALSE(thread.busy());
  }
}

TEST_F(GraphThreadTest, TellsTheCostOfTheLatestResultTaken) {
  GraphThread thread(Lockstep(5), &health_, [](PoseGraph* graph) {
    const bool fails = XOf(*graph) < 0.0;
    Summary summary = Ended(fails ? Termination::kFailure : Termination::kConverged);
    summary.final_cost = XOf(*graph);
    return summary;
  });
  EXPECT_FALSE(thread.latest_cost());
  thread.Run(GraphAt(3.0));
  EXPECT_EQ(thread.latest_cost(), 3.0);
  thread.Run(GraphAt(-1.0));
  EXPECT_EQ(thread.latest_cost(), 3.0);
}

}  // namespace
}  // namespace gmapping_spa::frontend
