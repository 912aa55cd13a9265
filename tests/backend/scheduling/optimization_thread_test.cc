#include "backend/scheduling/optimization_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <latch>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"
#include "backend/graph/initial_guess.h"
#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend {
namespace {

using ::testing::HasSubstr;

constexpr double kForEver = std::numeric_limits<double>::infinity();

Summary Converged() {
  Summary summary;
  summary.termination = Termination::kConverged;
  return summary;
}

Summary FollowOdometry(PoseGraph* graph) {
  Summary summary = Converged();
  summary.initial_cost = GraphCost(*graph);
  std::vector<SE2> poses = PosesOf(*graph);
  InitializeFromOdometry(*graph, IndexGraph(*graph), &poses);
  for (std::size_t k = 0; k < poses.size(); ++k) graph->nodes[k].world_T_node = poses[k];
  summary.final_cost = GraphCost(*graph);
  return summary;
}

// What a test and an optimization tell each other.
struct Gate {
  std::latch entered{1};  // by the optimization, when it begins
  std::latch opened{1};   // by the test, to let it go on
};

// Begins like a function that hangs, until the gate is opened.
OptimizationThread::OptimizeFunction FollowOdometryBehind(std::shared_ptr<Gate> gate) {
  return [gate = std::move(gate)](PoseGraph* graph) {
    gate->entered.count_down();
    gate->opened.wait();
    return FollowOdometry(graph);
  };
}

// Checks that the function leads to a failure for `reason`, and that it leaves no trace.
void ExpectFailure(OptimizationThread::OptimizeFunction optimize, const char* reason) {
  const PoseGraph graph = RandomGraph(3);
  OptimizationThread thread(std::move(optimize));
  thread.Start(graph);
  const auto result = thread.Wait(kForEver);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->summary.termination, Termination::kFailure);
  EXPECT_THAT(result->summary.message, HasSubstr(reason));
  EXPECT_EQ(PosesOf(result->graph), PosesOf(graph));
  EXPECT_EQ(result->graph.edges.size(), graph.edges.size());
}

TEST(OptimizationThread, GivesWhatADirectCallGives) {
  PoseGraph graph = RandomGraph(3);
  OptimizationThread thread(FollowOdometry);
  thread.Start(graph);
  const auto result = thread.Wait(kForEver);
  const Summary summary = FollowOdometry(&graph);
  ASSERT_TRUE(result);
  EXPECT_EQ(PosesOf(result->graph), PosesOf(graph));
  EXPECT_EQ(result->graph.edges.size(), graph.edges.size());
  EXPECT_EQ(result->summary.termination, summary.termination);
  EXPECT_EQ(result->summary.initial_cost, summary.initial_cost);
  EXPECT_EQ(result->summary.final_cost, summary.final_cost);
}

TEST(OptimizationThread, LetsTheCallerGoOnWhileItRuns) {
  const auto gate = std::make_shared<Gate>();
  OptimizationThread thread(FollowOdometryBehind(gate));
  PoseGraph graph = RandomGraph(3);
  const std::size_t nodes = graph.nodes.size();
  thread.Start(graph);
  gate->entered.wait();
  // The optimization has begun and ends only after this.
  EXPECT_TRUE(thread.busy());
  EXPECT_FALSE(thread.Poll());
  graph.nodes.clear();
  gate->opened.count_down();
  const auto result = thread.Wait(kForEver);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->graph.nodes.size(), nodes);
  EXPECT_FALSE(thread.busy());
}

TEST(OptimizationThread, WaitGivesUpAndTheResultCanBeTakenLater) {
  const auto gate = std::make_shared<Gate>();
  OptimizationThread thread(FollowOdometryBehind(gate));
  thread.Start(RandomGraph(3));
  EXPECT_FALSE(thread.Wait(0.01));
  EXPECT_FALSE(thread.Wait(-1.0));
  EXPECT_TRUE(thread.busy());
  gate->opened.count_down();
  auto result = thread.Poll();
  while (!result) result = thread.Poll();
  EXPECT_EQ(result->summary.termination, Termination::kConverged);
}

TEST(OptimizationThread, HasNothingToWaitForWhenIdle) {
  OptimizationThread thread(FollowOdometry);
  EXPECT_FALSE(thread.busy());
  EXPECT_FALSE(thread.Poll());
  EXPECT_FALSE(thread.Wait(kForEver));
  thread.Start(RandomGraph(3));
  EXPECT_TRUE(thread.Wait(kForEver));
  EXPECT_FALSE(thread.Wait(kForEver));  // a result is given once
}

TEST(OptimizationThread, RefusesASecondSnapshotUntilTheResultIsTaken) {
  const auto gate = std::make_shared<Gate>();
  OptimizationThread thread(FollowOdometryBehind(gate));
  thread.Start(RandomGraph(3));
  EXPECT_THROW(thread.Start(RandomGraph(4)), std::logic_error);
  gate->opened.count_down();
  const auto result = thread.Wait(kForEver);
  ASSERT_TRUE(result);
  PoseGraph expected = RandomGraph(3);
  FollowOdometry(&expected);
  EXPECT_EQ(PosesOf(result->graph), PosesOf(expected));
}

TEST(OptimizationThread, OptimizesOneSnapshotAfterAnother) {
  OptimizationThread thread(FollowOdometry);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    PoseGraph graph = RandomGraph(seed, {.nodes = 10 + static_cast<int>(seed)});
    thread.Start(graph);
    const auto result = thread.Wait(kForEver);
    FollowOdometry(&graph);
    ASSERT_TRUE(result);
    EXPECT_EQ(PosesOf(result->graph), PosesOf(graph));
  }
}

TEST(OptimizationThread, ContainsWhatIsThrown) {
  ExpectFailure(
      [](PoseGraph* graph) -> Summary {
        graph->nodes[1].world_T_node.x = 1e9;
        graph->edges.clear();
        throw std::runtime_error("out of cheese");
      },
      "out of cheese");
  ExpectFailure(
      [](PoseGraph* graph) -> Summary {
        graph->nodes.clear();
        throw 42;
      },
      "unknown type");
}

TEST(OptimizationThread, GoesOnAfterAFailure) {
  OptimizationThread thread([calls = 0](PoseGraph* graph) mutable {
    if (calls++ == 0) throw std::runtime_error("out of cheese");
    return FollowOdometry(graph);
  });
  thread.Start(RandomGraph(3));
  EXPECT_EQ(thread.Wait(kForEver)->summary.termination, Termination::kFailure);
  thread.Start(RandomGraph(3));
  EXPECT_EQ(thread.Wait(kForEver)->summary.termination, Termination::kConverged);
}

TEST(OptimizationThread, UndoesAReportedFailure) {
  ExpectFailure(
      [](PoseGraph* graph) {
        graph->nodes[2].world_T_node.x += 1e-3;
        Summary summary;
        summary.message = "gave up";
        return summary;
      },
      "gave up");
}

TEST(OptimizationThread, KeepsOutBadPosesByOptimizeSafely) {
  // Adds `by` to an orientation.
  class Spoiler : public Optimizer {
   public:
    explicit Spoiler(double by) : by_(by) {}
    Summary Optimize(const Options&, std::span<const Edge>, std::span<Node> nodes) override {
      nodes.back().world_T_node.theta += by_;
      return Converged();
    }

   private:
    double by_;
  };
  const auto safely = [](double by) {
    return [optimizer = std::make_shared<Spoiler>(by)](PoseGraph* graph) {
      return OptimizeSafely({}, optimizer.get(), graph);
    };
  };
  ExpectFailure(safely(std::numeric_limits<double>::quiet_NaN()), "not finite");
  ExpectFailure(safely(2.0), "poses that cost");
  // A malformed graph is what OptimizeSafely itself throws at.
  PoseGraph malformed = RandomGraph(3);
  malformed.nodes[8].id = 7;
  OptimizationThread thread(safely(0.0));
  thread.Start(malformed);
  const auto result = thread.Wait(kForEver);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->summary.termination, Termination::kFailure);
  EXPECT_THAT(result->summary.message, HasSubstr("two nodes have the id 7"));
}

// The function is destroyed when neither the object nor its thread is there any more.

TEST(OptimizationThread, EndsItsThreadWhenDestroyedIdle) {
  auto owned = std::make_shared<int>();
  const std::weak_ptr<int> observed = owned;
  {
    const OptimizationThread thread([owned = std::move(owned)](PoseGraph*) { return Converged(); },
                                    0.0);
  }
  EXPECT_TRUE(observed.expired());
}

TEST(OptimizationThread, EndsItsThreadWhenDestroyedWithAResultNotTaken) {
  auto owned = std::make_shared<std::promise<void>>();
  const std::weak_ptr<std::promise<void>> observed = owned;
  std::future<void> called = owned->get_future();
  {
    OptimizationThread thread(
        [owned = std::move(owned)](PoseGraph*) {
          owned->set_value();
          return Converged();
        },
        kForEver);
    thread.Start(RandomGraph(3));
    called.wait();
  }
  EXPECT_TRUE(observed.expired());
}

TEST(OptimizationThread, WaitsForARunningOptimizationWhenDestroyed) {
  auto gate = std::make_shared<Gate>();
  const std::weak_ptr<Gate> observed = gate;
  auto thread = std::make_unique<OptimizationThread>(FollowOdometryBehind(gate), kForEver);
  thread->Start(RandomGraph(3));
  gate->entered.wait();
  std::future<void> destroyed = std::async(std::launch::async, [&] { thread.reset(); });
  EXPECT_EQ(destroyed.wait_for(std::chrono::milliseconds(10)), std::future_status::timeout);
  gate->opened.count_down();
  destroyed.wait();
  gate.reset();
  EXPECT_TRUE(observed.expired());
}

TEST(OptimizationThread, LeavesAHungOptimizationToItselfWhenDestroyed) {
  // Tells when the function is destroyed, which is the last that the thread left behind does.
  struct Farewell {
    ~Farewell() { said.set_value(); }
    std::promise<void> said;
  };
  const auto gate = std::make_shared<Gate>();
  auto farewell = std::make_shared<Farewell>();
  std::future<void> ended = farewell->said.get_future();
  {
    OptimizationThread thread(
        [farewell = std::move(farewell), gate](PoseGraph*) {
          gate->entered.count_down();
          gate->opened.wait();
          return Converged();
        },
        0.01);
    thread.Start(RandomGraph(3));
    gate->entered.wait();
  }
  // The destructor has returned while the optimization still hangs.
  EXPECT_EQ(ended.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  gate->opened.count_down();
  ended.wait();
}

}  // namespace
}  // namespace gmapping_spa::backend
