// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/graph_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <semaphore>
#include <stdexcept>
#include <thread>
#include <utility>

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::Summary;
using backend::Termination;

Summary Ended(Termination termination) {
  Summary summary;
  summary.termination = termination;
  return summary;
}

// A back end that works for as long as the test wants: each call waits for one Allow(), then moves
// node 0 by a metre.
class Backend {
 public:
  GraphThread::OptimizeFunction Function() const {
    return [state = state_](PoseGraph* graph) {
      state->allowed.acquire();
      graph->nodes.at(0).world_T_node.x += 1.0;
      return Ended(Termination::kConverged);
    };
  }
  void Allow(int calls = 1) const { state_->allowed.release(calls); }

 private:
  struct State {
    std::counting_semaphore<> allowed{0};
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

PoseGraph GraphAt(double x) { return {.nodes = {{.world_T_node = {x, 0, 0}}}, .edges = {}}; }

double XOf(const PoseGraph& graph) { return graph.nodes.at(0).world_T_node.x; }

GraphThread::Options Lockstep(int scans, double timeout_s = 60.0) {
  return {GraphThread::Mode::kLockstep, scans, timeout_s};
}

std::int64_t CountOf(const Health& health, const char* kind) {
  const auto found = health.findings().find(kind);
  return found == health.findings().end() ? 0 : found->second.count;
}

// Tries until a result comes, for five seconds at most.
std::optional<PoseGraph> TryUntilTaken(GraphThread* thread) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::chrono::steady_clock::now() < deadline) {
    if (auto graph = thread->TakeIfDue(0.0)) return graph;
    std::this_thread::yield();
  }
  return std::nullopt;
}

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
  const Backend backend;
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
  const Backend backend;
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
  const Backend backend;
  GraphThread thread({GraphThread::Mode::kInline, 10, 60.0}, &health_, backend.Function());
  thread.Start(GraphAt(10));
  const std::jthread allow([&backend] { backend.Allow(); });
  const std::optional<PoseGraph> taken = thread.TakeIfDue(0.0);
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
}

TEST_F(GraphThreadTest, AsyncDoesNotWaitAndTakesTheResultWhenItIsThere) {
  const Backend backend;
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

TEST_F(GraphThreadTest, FailureCostsOnlyItsResult) {
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

TEST_F(GraphThreadTest, GoesOnWithoutABackEndThatHangsAndTakesItsResultWhenItComes) {
  for (const GraphThread::Mode mode : {GraphThread::Mode::kLockstep, GraphThread::Mode::kInline}) {
    const Backend backend;
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

TEST_F(GraphThreadTest, WaitsForABackEndThatHangsOnlyOnce) {
  const Backend backend;
  GraphThread thread(Lockstep(1, 0.1), &health_, backend.Function());
  thread.Start(GraphAt(10));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(thread.TakeIfDue(0.0));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(100));
  for (int scan = 0; scan < 50; ++scan) EXPECT_FALSE(thread.TakeIfDue(0.0));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  backend.Allow();
}

TEST_F(GraphThreadTest, TimeoutOfZeroTakesWhatIsThere) {
  for (const GraphThread::Mode mode :
       {GraphThread::Mode::kLockstep, GraphThread::Mode::kInline, GraphThread::Mode::kAsync}) {
    const Backend backend;
    backend.Allow();
    GraphThread thread({mode, 2, 0.0}, &health_, backend.Function());
    thread.Start(GraphAt(10));
    EXPECT_TRUE(TryUntilTaken(&thread)) << static_cast<int>(mode);
  }
}

TEST_F(GraphThreadTest, FinishTakesWhatRunsBeforeItIsDue) {
  const Backend backend;
  backend.Allow();
  GraphThread thread(Lockstep(100), &health_, backend.Function());
  EXPECT_FALSE(thread.Finish()) << "nothing was started";
  thread.Start(GraphAt(10));
  const std::optional<PoseGraph> taken = thread.Finish();
  ASSERT_TRUE(taken);
  EXPECT_EQ(XOf(*taken), 11);
  EXPECT_FALSE(thread.Finish());
}

TEST_F(GraphThreadTest, FinishGivesUpOnABackEndThatHangs) {
  const Backend backend;
  GraphThread thread(Lockstep(100, 0.005), &health_, backend.Function());
  thread.Start(GraphAt(10));
  EXPECT_FALSE(thread.Finish());
  EXPECT_TRUE(thread.busy());
  EXPECT_EQ(thread.counts().taken, 0);
  EXPECT_EQ(thread.counts().failed, 0);
  backend.Allow();
}

TEST_F(GraphThreadTest, RunWaitsForTheResult) {
  const Backend backend;
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

TEST_F(GraphThreadTest, RunGivesNothingWhileTheBackEndHangs) {
  const Backend backend;
  GraphThread thread(Lockstep(1, 0.005), &health_, backend.Function());
  thread.Start(GraphAt(10));
  EXPECT_FALSE(thread.Run(GraphAt(20)));
  EXPECT_EQ(thread.counts().started, 1);
  EXPECT_EQ(CountOf(health_, "backend_busy"), 1);
  backend.Allow();
}

TEST_F(GraphThreadTest, ReportsWithTheStampOfTheLatestScan) {
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

TEST_F(GraphThreadTest, ABackEndThatConvergesIsNothingToReport) {
  const Backend backend;
  backend.Allow();
  GraphThread thread(Lockstep(1), &health_, backend.Function());
  thread.Start(GraphAt(10));
  EXPECT_TRUE(thread.TakeIfDue(0.0));
  EXPECT_TRUE(health_.findings().empty());
}

}  // namespace
}  // namespace gmapping_spa::frontend
