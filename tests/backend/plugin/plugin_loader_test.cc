// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/plugin_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/random_graph.h"
#include "tests/built_back_ends.h"
#include "tests/message_of.h"

namespace gmapping_spa::backend {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StrEq;
using ::testing::ThrowsMessage;

const std::vector<std::string> kFolders = {TEST_PLUGIN_FOLDER};

std::string ErrorOf(const std::string& name) {
  return MessageOf([&] { LoadOptimizer(name, kFolders); });
}

std::string PathOf(const std::string& name) {
  return std::string(TEST_PLUGIN_FOLDER) + "/libgmapping_spa_" + name + ".so";
}

TEST(LoadOptimizer, FindsBackEndsByNameInTheBuildTree) {
  PoseGraph graph = RandomGraph(1);
  for (const char* name : Built({"none", "spa", "ceres"})) {
    const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(name);
    EXPECT_NE(OptimizeSafely({}, optimizer.get(), &graph).termination, Termination::kFailure)
        << name;
  }
}

TEST(LoadOptimizer, TakesAPathForAFile) {
  EXPECT_EQ(ErrorOf(PathOf("nan")), "no error");
  EXPECT_EQ(ErrorOf("/no/such/libmine.so"),
            "cannot load the back end /no/such/libmine.so: there is no such file");
}

TEST(LoadOptimizer, SaysWhereItSearchedInVain) {
  EXPECT_EQ(ErrorOf("missing"),
            "there is no back end 'missing' (libgmapping_spa_missing.so) in " TEST_PLUGIN_FOLDER);
}

TEST(LoadOptimizer, SaysWhatIsWrongWithAPlugin) {
  EXPECT_THAT(ErrorOf("wrong_abi"), HasSubstr("it has ABI version 3, expected 2; rebuild it"));
  EXPECT_THAT(ErrorOf("without_entry_point"),
              HasSubstr("it has no function gmapping_spa_backend_plugin"));
  EXPECT_THAT(ErrorOf("throwing_entry_point"), HasSubstr("its entry point threw an exception"));
  EXPECT_THAT(ErrorOf("throwing_factory"), HasSubstr("cannot make an optimizer: no licence found"));
}

TEST(LoadOptimizer, SaysThatAFileIsNoLibrary) {
  const std::string path = ::testing::TempDir() + "/libnot.so";
  std::ofstream(path) << "not a library";
  EXPECT_THAT(ErrorOf(path),
              AllOf(HasSubstr(path), HasSubstr("cannot load the back end"), Not(HasSubstr("\n"))));
  std::filesystem::remove(path);
}

TEST(LoadOptimizer, ContainsWhatAPluginThrowsAndReturns) {
  PoseGraph graph = RandomGraph(1);
  const SE2 before = graph.nodes[3].world_T_node;
  std::unique_ptr<Optimizer> optimizer = LoadOptimizer("throwing", kFolders);
  Summary summary = OptimizeSafely({}, optimizer.get(), &graph);
  EXPECT_EQ(summary.termination, Termination::kFailure);
  EXPECT_EQ(summary.message, "out of cheese");
  optimizer = LoadOptimizer("nan", kFolders);
  summary = OptimizeSafely({}, optimizer.get(), &graph);
  EXPECT_EQ(summary.termination, Termination::kFailure);
  EXPECT_THAT(summary.message, HasSubstr("not finite"));
  EXPECT_EQ(graph.nodes[3].world_T_node, before);
}

TEST(LoadOptimizer, CarriesOptionsAndIterationsAcrossTheBoundary) {
  PoseGraph graph = RandomGraph(1);
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer("spa");
  Options options;
  options.max_iterations = 2;
  options.cost_tolerance = 0.0;
  const Summary summary = optimizer->Optimize(options, graph.edges, graph.nodes);
  EXPECT_EQ(summary.termination, Termination::kNoConvergence);
  EXPECT_EQ(summary.iterations.size(), 2u);
  options.max_solver_time_s = 0.0;
  const Summary late = optimizer->Optimize(options, graph.edges, graph.nodes);
  EXPECT_EQ(late.termination, Termination::kNoConvergence);
  EXPECT_EQ(late.message, "ran out of time");
}

TEST(LoadOptimizer, RefusesSettingsAndLossesThatTheBackEndDoesNotHave) {
  const std::unique_ptr<Optimizer> spa = LoadOptimizer("spa");
  Options options;
  options.settings["max_nonmonotonic_steps"] = "-1";
  EXPECT_THAT([&] { spa->CheckOptions(options); },
              ThrowsMessage<std::runtime_error>("back end spa: setting max_nonmonotonic_steps: "
                                                "expected an integer of at least 0, got '-1'"));
  options.settings = {{"slover", "block"}};
  PoseGraph graph = RandomGraph(1);
  const Summary failed = OptimizeSafely(options, spa.get(), &graph);
  EXPECT_EQ(failed.termination, Termination::kFailure);
  EXPECT_THAT(failed.message, HasSubstr("unknown setting slover"));
  options = {};
  options.loss.kind = LossKind::kHuber;
  EXPECT_NO_THROW(spa->CheckOptions(options));
  // Its author said nothing of losses.
  const std::unique_ptr<Optimizer> other = LoadOptimizer("nan", kFolders);
  EXPECT_THAT([&] { other->CheckOptions(options); },
              ThrowsMessage<std::runtime_error>(
                  "back end misbehaving: expected a loss out of none, got 'huber'"));
}

TEST(LoadOptimizer, TakesAPluginInPlainC) {
  PoseGraph graph = RandomGraph(1), expected = graph;
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer("plain_c", kFolders);
  Options options;
  options.settings = {{"x_m", "1.5"}};
  const Summary summary = optimizer->Optimize(options, graph.edges, graph.nodes);
  EXPECT_EQ(summary.termination, Termination::kNoConvergence);
  EXPECT_EQ(summary.message, "moved the last node");
  ASSERT_EQ(summary.iterations.size(), 1u);
  EXPECT_EQ(summary.iterations[0].cost, 7.0);
  // It found the last node from the last edge, by id, and its place by the setting.
  expected.nodes.back().world_T_node.x = 1.5;
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    EXPECT_EQ(graph.nodes[k].world_T_node, expected.nodes[k].world_T_node) << k;
  }
}

TEST(LoadOptimizer, CarriesCovariancesAcrossTheBoundary) {
  const PoseGraph graph = RandomGraph(1);
  const std::vector<EdgeNodes> pairs = {{2, 2}, {7, 4}};
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer("plain_c_covariances", kFolders);
  ASSERT_TRUE(optimizer->HasCovariances());
  const std::vector<Eigen::Matrix3d> covariances =
      optimizer->Covariances(graph.edges, graph.nodes, pairs);
  ASSERT_EQ(covariances.size(), 2u);
  EXPECT_EQ(covariances[0](0, 2), 2.0202);  // column 2 of row 0 of the nodes 2 and 2
  EXPECT_EQ(covariances[1](2, 1), 7.0421);
  EXPECT_EQ(MessageOf([&] { optimizer->Covariances({}, {}, pairs); }), "no graph, no covariances");
}

// Plugins that were built before the ability came load as they did, and have it not.
TEST(LoadOptimizer, KnowsAPluginWithoutCovariances) {
  for (const char* name : {"plain_c", "nan"}) {
    const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(name, kFolders);
    EXPECT_FALSE(optimizer->HasCovariances()) << name;
    EXPECT_EQ(MessageOf([&] { optimizer->Covariances({}, {}, {}); }),
              "the back end has no covariances of its own");
  }
}

TEST(PluginSearchPath, StartsWithTheEnvironment) {
  setenv("GMAPPING_SPA_PLUGIN_PATH", "/first::/second", 1);
  const std::vector<std::string> folders = PluginSearchPath();
  unsetenv("GMAPPING_SPA_PLUGIN_PATH");
  ASSERT_GE(folders.size(), 3u);
  EXPECT_EQ(folders[0], "/first");
  EXPECT_EQ(folders[1], "/second");
}

TEST(ListBackends, DescribesGoodOnesAndSaysWhatIsWrongWithOthers) {
  std::vector<std::string> folders = PluginSearchPath();
  folders.insert(folders.end(), kFolders.begin(), kFolders.end());
  const std::vector<BackendDescription> backends = ListBackends(folders);
  EXPECT_THAT(
      backends,
      Contains(
          AllOf(Field(&BackendDescription::name, "spa"), Field(&BackendDescription::loadable, true),
                Field(&BackendDescription::has_covariances, true),
                Field(&BackendDescription::losses, "none, huber, cauchy, dcs, truncated"),
                Field(&BackendDescription::settings,
                      Contains(Field(&SettingDescription::name, StrEq("damping")))),
                Field(&BackendDescription::description, HasSubstr("Sparse Pose Adjustment")))));
  EXPECT_THAT(backends, Contains(AllOf(Field(&BackendDescription::name, "plain_c"),
                                       Field(&BackendDescription::loadable, true),
                                       Field(&BackendDescription::has_covariances, false))));
  EXPECT_THAT(backends,
              Contains(AllOf(Field(&BackendDescription::name, "wrong_abi"),
                             Field(&BackendDescription::loadable, false),
                             Field(&BackendDescription::description, HasSubstr("ABI version")))));
}

}  // namespace
}  // namespace gmapping_spa::backend
