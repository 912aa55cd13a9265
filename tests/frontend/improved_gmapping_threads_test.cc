// SPDX-License-Identifier: BSD-3-Clause
// ImprovedGmapping with threads for particles, and with back ends that hang, fail or take their
// time on a thread of their own.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <memory>
#include <semaphore>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/frontend/loop_drive.h"

namespace gmapping_spa::frontend {
namespace {

using backend::PoseGraph;
using backend::Summary;

// In a program of its own, which the thread sanitizer watches.
class LoopDriveThreads : public LoopDrive {};

class NanOptimizer : public backend::Optimizer {
 public:
  Summary Optimize(const backend::Options&, std::span<const backend::Edge>,
                   std::span<backend::Node> nodes) override {
    for (backend::Node& node : nodes) {
      node.world_T_node.x = std::numeric_limits<double>::quiet_NaN();
    }
    return NoBackEnd(nullptr);
  }
};

TEST_F(LoopDriveThreads, ABackEndThatMisbehavesIsAsGoodAsNone) {
  const std::string& expected = BytesWithoutABackEnd();

  const auto gmapping = Drive(Options(), Safely(std::make_shared<NanOptimizer>()));
  EXPECT_EQ(TumBytes(gmapping->Finish().trajectory), expected);
  EXPECT_GT(gmapping->graph_thread().counts().failed, 3);

  EXPECT_EQ(
      TrajectoryBytes(Options(), [](PoseGraph*) -> Summary { throw std::runtime_error("no"); }),
      expected);
}

TEST_F(LoopDriveThreads, ABackEndThatHangsIsAsGoodAsNone) {
  const auto end = std::make_shared<std::binary_semaphore>(0);
  ImprovedGmapping::Options options = Options();
  options.graph_thread.timeout_s = 0.005;
  const auto gmapping = Drive(options, [end](PoseGraph* graph) {
    end->acquire();
    return NoBackEnd(graph);
  });
  EXPECT_EQ(TumBytes(gmapping->Finish().trajectory), BytesWithoutABackEnd());
  EXPECT_EQ(gmapping->graph_thread().counts().started, 1);
  EXPECT_EQ(gmapping->health().findings().count("backend_late"), 1u);
  EXPECT_EQ(gmapping->health().findings().count("backend_busy"), 1u);
  end->release();
}

TEST_F(LoopDriveThreads, LockstepDoesNotDependOnThreadsNorOnHowFastTheBackEndIs) {
  const std::string expected = TrajectoryBytes(Options(), Spa());
  EXPECT_NE(expected, BytesWithoutABackEnd());
  ImprovedGmapping::Options threads = Options();
  threads.filter.threads = 2;
  EXPECT_EQ(TrajectoryBytes(threads, Spa()), expected);
  const GraphThread::OptimizeFunction slow = [spa = Spa()](PoseGraph* graph) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return spa(graph);
  };
  EXPECT_EQ(TrajectoryBytes(Options(), slow), expected);
}

TEST_F(LoopDriveThreads, AsyncAndInlineEndNearLockstep) {
  for (const GraphThread::Mode mode : {GraphThread::Mode::kAsync, GraphThread::Mode::kInline}) {
    ImprovedGmapping::Options options = Options();
    options.graph_thread.mode = mode;
    EXPECT_LT(LargestError(Drive(options, Spa())->Finish().trajectory), 0.15);
  }
}

}  // namespace
}  // namespace gmapping_spa::frontend
