// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/process_optimizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/random_graph.h"
#include "tests/built_back_ends.h"
#include "tests/message_of.h"

namespace gmapping_spa::backend {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// Longer than any machine takes for what does not hang.
constexpr double kAmple_s = 60.0;

std::string Misbehaving(const std::string& fault) {
  return std::string(TEST_PLUGIN_FOLDER) + "/libgmapping_spa_" + fault + ".so";
}

std::string ErrorOfLoading(const std::string& fault) {
  return MessageOf([&] { ProcessOptimizer(Misbehaving(fault), kAmple_s); });
}

// The message of its failure, with the graph as it was.
std::string FailureOf(ProcessOptimizer* optimizer) {
  PoseGraph graph = RandomGraph(1);
  const std::vector<SE2> before = PosesOf(graph);
  const Summary summary = OptimizeSafely({}, optimizer, &graph);
  EXPECT_EQ(summary.termination, Termination::kFailure);
  EXPECT_EQ(PosesOf(graph), before);
  return summary.message;
}

std::string FailureOf(const std::string& fault, double timeout_s = kAmple_s) {
  ProcessOptimizer optimizer(Misbehaving(fault), timeout_s);
  return FailureOf(&optimizer);
}

TEST(ProcessOptimizer, ReturnsTheSamePosesToTheBit) {
  for (const char* name : Built({"none", "spa", "ceres"})) {
    ProcessOptimizer apart(name, kAmple_s);
    const std::unique_ptr<Optimizer> here = LoadOptimizer(name);
    for (unsigned seed = 1; seed < 4; ++seed) {  // it keeps what it learned, or learns anew
      PoseGraph graph = RandomGraph(seed), same = graph;
      Options options;
      options.loss.kind = LossKind::kHuber;
      const Summary summary = OptimizeSafely(options, &apart, &graph);
      const Summary expected = OptimizeSafely(options, here.get(), &same);
      EXPECT_EQ(PosesOf(graph), PosesOf(same)) << name;
      EXPECT_EQ(summary.termination, expected.termination) << name;
      EXPECT_EQ(summary.message, expected.message) << name;
      EXPECT_EQ(summary.final_cost, expected.final_cost) << name;
      EXPECT_EQ(summary.iterations.size(), expected.iterations.size()) << name;
    }
  }
}

TEST(ProcessOptimizer, RefusesWhatTheBackEndCannotDo) {
  const ProcessOptimizer apart("spa", kAmple_s);
  const std::unique_ptr<Optimizer> here = LoadOptimizer("spa");
  Options options;
  options.settings["solver"] = "magic";
  EXPECT_EQ(MessageOf([&] { apart.CheckOptions(options); }),
            MessageOf([&] { here->CheckOptions(options); }));
  EXPECT_NO_THROW(apart.CheckOptions({}));
}

TEST(ProcessOptimizer, SaysLikeTheLoaderWhatCannotBeLoaded) {
  for (const char* fault : {"wrong_abi", "without_entry_point", "throwing_factory", "missing"}) {
    EXPECT_EQ(ErrorOfLoading(fault), MessageOf([&] { LoadOptimizer(Misbehaving(fault)); }));
  }
  EXPECT_THAT(MessageOf([] { ProcessOptimizer("missing", kAmple_s); }),
              StartsWith("there is no back end 'missing'"));
}

TEST(ProcessOptimizer, SaysThatAPluginCrashesWhenItIsLoaded) {
  EXPECT_EQ(ErrorOfLoading("crashing_factory"), "the back end crashed with signal 6 (Aborted)");
}

TEST(ProcessOptimizer, StopsABackEndThatHangs) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(FailureOf("hanging", 0.5), "the back end took longer than 0.5 s and was stopped");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(ProcessOptimizer, SurvivesABackEndThatCrashes) {
  EXPECT_EQ(FailureOf("crashing"), "the back end crashed with signal 11 (Segmentation fault)");
}

TEST(ProcessOptimizer, SurvivesABackEndThatEndsTheProcess) {
  EXPECT_EQ(FailureOf("exiting"), "the back end exited with status 3");
}

TEST(ProcessOptimizer, RefusesAnAnswerThatIsNone) {
  EXPECT_EQ(FailureOf("babbling"),
            "the process of the back end answered with what is no result, and was stopped");
}

TEST(ProcessOptimizer, HandsOnWhatTheBackEndThrowsAndGetsWrong) {
  EXPECT_THAT(FailureOf("throwing"), HasSubstr("out of cheese"));
  EXPECT_THAT(FailureOf("nan"), HasSubstr("not finite"));
}

TEST(ProcessOptimizer, HasANewProcessAfterAFailure) {
  ProcessOptimizer optimizer(Misbehaving("crashing"), kAmple_s);
  const std::string first = FailureOf(&optimizer);
  EXPECT_EQ(FailureOf(&optimizer), first) << "not that there is no process any more";
}

TEST(ProcessOptimizer, NeedsATimeToWait) {
  EXPECT_THAT(MessageOf([] { ProcessOptimizer("spa", 0.0); }), HasSubstr("above 0 s"));
}

// The back end holds the write end of a pipe as long as it is there.
TEST(ProcessOptimizer, LeavesNoProcessBehindWhenTheProgramIsKilled) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t program = fork();
  if (program == 0) {
    close(ends[0]);
    ProcessOptimizer optimizer(Misbehaving("hanging"), kAmple_s);
    std::thread([&] {
      PoseGraph graph = RandomGraph(1);
      OptimizeSafely({}, &optimizer, &graph);
    }).detach();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    raise(SIGKILL);
  }
  close(ends[1]);
  EXPECT_EQ(waitpid(program, nullptr, 0), program);
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 0) << "end of the pipe: nobody can write to it";
  close(ends[0]);
}

}  // namespace
}  // namespace gmapping_spa::backend
