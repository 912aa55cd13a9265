// SPDX-License-Identifier: BSD-3-Clause
// How a graph thread ends: its function is destroyed when neither the object nor its thread is
// there any more. What it refuses is here too.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <latch>
#include <limits>
#include <memory>
#include <utility>

#include "frontend/graph_thread.h"

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::Summary;

// Tells when it is destroyed.
struct Farewell {
  Farewell() = default;
  Farewell(const Farewell&) = delete;
  Farewell& operator=(const Farewell&) = delete;
  ~Farewell() { said.set_value(); }
  std::promise<void> said;
};

// What a test and an optimization tell each other.
struct Gate {
  std::latch entered{1};  // by the optimization, when it begins
  std::latch opened{1};   // by the test, to let it go on
};

bool IsReady(const std::future<void>& future) {
  return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

class GraphThreadEnd : public testing::Test {
 protected:
  // With a back end that hangs until the gate is opened.
  std::unique_ptr<GraphThread> MakeThread(double patience_s) {
    return std::make_unique<GraphThread>(
        GraphThread::Options{.patience_s = patience_s}, &health_,
        [gate = gate_, farewell = std::move(farewell_)](PoseGraph*) {
          gate->entered.count_down();
          gate->opened.wait();
          return Summary();
        });
  }

  Health health_;
  const std::shared_ptr<Gate> gate_ = std::make_shared<Gate>();
  std::shared_ptr<Farewell> farewell_ = std::make_shared<Farewell>();
  const std::future<void> ended_ = farewell_->said.get_future();
};

constexpr double kForEver = std::numeric_limits<double>::infinity();

TEST_F(GraphThreadEnd, DoesNotWaitWhenIdle) {
  MakeThread(0.0).reset();
  EXPECT_TRUE(IsReady(ended_));
}

TEST_F(GraphThreadEnd, DropsAResultThatWasNotTaken) {
  gate_->opened.count_down();
  std::unique_ptr<GraphThread> thread = MakeThread(kForEver);
  thread->Start({});
  gate_->entered.wait();
  thread.reset();
  EXPECT_TRUE(IsReady(ended_));
}

TEST_F(GraphThreadEnd, WaitsForWhatRuns) {
  std::unique_ptr<GraphThread> thread = MakeThread(kForEver);
  thread->Start({});
  gate_->entered.wait();
  const std::future<void> destroyed = std::async(std::launch::async, [&] { thread.reset(); });
  EXPECT_EQ(destroyed.wait_for(std::chrono::milliseconds(10)), std::future_status::timeout);
  EXPECT_FALSE(IsReady(ended_));
  gate_->opened.count_down();
  destroyed.wait();
  EXPECT_TRUE(IsReady(ended_));
}

TEST_F(GraphThreadEnd, LeavesWhatHangsToItself) {
  std::unique_ptr<GraphThread> thread = MakeThread(0.01);
  thread->Start({});
  gate_->entered.wait();
  thread.reset();
  // The destructor has returned while the optimization still hangs.
  EXPECT_FALSE(IsReady(ended_));
  gate_->opened.count_down();
  ended_.wait();
}

TEST_F(GraphThreadEnd, WaitsForWhatHangsNoLongerThanSecondsOnceItIsAsked) {
  std::unique_ptr<GraphThread> thread = MakeThread(kForEver);
  std::atomic<bool> asked = false;
  thread->StopWaitingWhen([&] { return asked.load(); });
  thread->Start({});
  gate_->entered.wait();
  const std::future<void> destroyed = std::async(std::launch::async, [&] {
    EXPECT_FALSE(thread->Finish());
    EXPECT_FALSE(thread->Run({}));
    thread.reset();
  });
  EXPECT_EQ(destroyed.wait_for(std::chrono::milliseconds(300)), std::future_status::timeout);
  const auto start = std::chrono::steady_clock::now();
  asked = true;
  destroyed.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  gate_->opened.count_down();
  ended_.wait();
}

using GraphThreadDeathTest = GraphThreadEnd;

TEST_F(GraphThreadDeathTest, OptimizesOneSnapshotAtATime) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const std::unique_ptr<GraphThread> thread = MakeThread(kForEver);
  thread->Start({});
  EXPECT_DEATH(thread->Start({}), "busy");
  gate_->opened.count_down();
}

TEST_F(GraphThreadDeathTest, LockstepNeedsAtLeastOneScan) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_DEATH(GraphThread({.lockstep_scans = 0}, &health_, {}), "lockstep_scans");
}

}  // namespace
}  // namespace gmapping_spa::frontend
