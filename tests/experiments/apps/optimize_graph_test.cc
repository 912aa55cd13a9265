// SPDX-License-Identifier: BSD-3-Clause
// The command line of optimize_graph.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "backend/cost/graph_cost.h"
#include "backend/graph/g2o_io.h"
#include "tests/built_back_ends.h"
#include "tests/command_error.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class OptimizeGraph : public ::testing::Test {
 protected:
  // A unit square walked with too much left turn, closed by a loop closure.
  TemporaryFolder folder_;
  std::string graph_ = folder_.FileWith("square.g2o",
                                        "EDGE_SE2 0 1 1 0 1.6 100 0 0 100 0 100\n"
                                        "EDGE_SE2 1 2 1 0 1.6 100 0 0 100 0 100\n"
                                        "EDGE_SE2 2 3 1 0 1.6 100 0 0 100 0 100\n"
                                        "EDGE_SE2 3 0 1 0 1.6 100 0 0 100 0 100\n");

  static CommandResult Run(std::vector<std::string> flags) {
    flags.insert(flags.begin(), OPTIMIZE_GRAPH);
    return RunCommand(flags);
  }

  static std::string ErrorOf(std::vector<std::string> flags) {
    flags.insert(flags.begin(), OPTIMIZE_GRAPH);
    return gmapping_spa::ErrorOf(flags);
  }
};

TEST_F(OptimizeGraph, PrintsTheSummaryAndWritesTheGraph) {
  for (const char* backend : Built({"spa", "ceres"})) {
    const std::string output = folder_.Path("out.g2o");
    const CommandResult result =
        Run({"--input=" + graph_, "--output=" + output, std::string("--backend=") + backend});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["termination"], "converged");
    EXPECT_EQ(json["nodes"], 4);
    EXPECT_LT(json["final_cost"], json["initial_cost"]);
    std::ifstream file(output);
    EXPECT_EQ(backend::GraphCost(backend::ReadG2o(file, output)), json["final_cost"]);
  }
}

TEST_F(OptimizeGraph, WritesThePosesItGotWithoutABackEnd) {
  const std::string output = folder_.Path("out.g2o"), again = folder_.Path("again.g2o");
  ASSERT_EQ(Run({"--input=" + graph_, "--output=" + output, "--backend=none"}).status, 0);
  ASSERT_EQ(Run({"--input=" + output, "--output=" + again, "--backend=none"}).status, 0);
  const auto text = [](const std::string& path) {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_THAT(text(output), HasSubstr("VERTEX_SE2 0 0 0 0\n"));
  EXPECT_EQ(text(output), text(again));
}

TEST_F(OptimizeGraph, StampsBesideTheInputComeOutBesideTheOutput) {
  folder_.FileWith("square.stamps", "0 10\n1 976052857.33753\n2 30\n3 40.5\n");
  const std::string output = folder_.Path("out.g2o"), stamps = folder_.Path("out.stamps");
  const CommandResult result = Run({"--input=" + graph_, "--output=" + output});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["has_stamps"], true);
  std::ifstream file(stamps);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}),
            "0 10\n1 976052857.33753\n2 30\n3 40.5\n");

  folder_.FileWith("square.stamps", "0 10\n7 5\n");
  EXPECT_EQ(ErrorOf({"--input=" + graph_, "--output=" + output}),
            "optimize_graph: error: " + folder_.Path("square.stamps") +
                ":2: expected the id of a node, found 7\n");
}

TEST_F(OptimizeGraph, AGraphWithoutStampsDoesNotTakeThoseOfAnother) {
  const std::string output = folder_.Path("out.g2o"), stamps = folder_.FileWith("out.stamps", "");
  EXPECT_EQ(ErrorOf({"--input=" + graph_, "--output=" + output}),
            "optimize_graph: error: " + stamps +
                ": expected no such file, which would be taken for the stamps of " + output + ": " +
                graph_ + " has none\n");
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(OptimizeGraph, DrawsAPicture) {
  const std::string png = folder_.Path("graph.png");
  ASSERT_EQ(Run({"--input=" + graph_, "--png=" + png}).status, 0);
  std::ifstream file(png, std::ios::binary);
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(file), {}), StartsWith("\x89PNG"));
}

TEST_F(OptimizeGraph, PrintsOneLineAnIterationWhenVerbose) {
  const CommandResult result = Run({"--input=" + graph_, "--verbose"});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'),
            1 + static_cast<int>(json["iterations"].size()));
}

TEST_F(OptimizeGraph, PassesTheSettingsOfTheBackEnd) {
  const CommandResult result =
      Run({"--input=" + graph_, "--spa_max_nonmonotonic_steps=3", "--loss=truncated",
           "--ceres_threads=3", "--backend_settings=damping=0.5"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["settings"],
            (nlohmann::json{{"max_nonmonotonic_steps", "3"}, {"damping", "0.5"}}));
  EXPECT_EQ(json["loss"], "truncated");
  EXPECT_THAT(result.err, HasSubstr("--ceres_threads has no effect with --backend=spa"));
}

TEST_F(OptimizeGraph, ListsBackEnds) {
  const CommandResult result = Run({"--list_backends"});
  EXPECT_EQ(result.status, 0);
  for (const char* name : Built({"ceres", "none", "spa"})) {
    EXPECT_THAT(result.out, HasSubstr(std::string(name) + "\n"));
  }
  EXPECT_THAT(result.out, HasSubstr("damping (a number of at least 0, default 0): "));
}

// A ring of 12 nodes, whose poses turn twice on the way around: a local minimum.
std::string WoundRing() {
  constexpr int kNodes = 12;
  constexpr double kTurn = 2.0 * 3.14159265358979 / kNodes;
  std::string text;
  double x = 0.0, y = 0.0;
  for (int k = 0; k < kNodes; ++k) {
    const std::string next = std::to_string((k + 1) % kNodes);
    text += "VERTEX_SE2 " + std::to_string(k) + " " + std::to_string(x) + " " + std::to_string(y) +
            " " + std::to_string(2.0 * k * kTurn) + "\n";
    text += "EDGE_SE2 " + std::to_string(k) + " " + next + " 1 0 " + std::to_string(kTurn) +
            " 100 0 0 100 0 100\n";
    x += std::cos(2.0 * k * kTurn);
    y += std::sin(2.0 * k * kTurn);
  }
  return text;
}

TEST_F(OptimizeGraph, CertifiesTheGlobalOptimum) {
  const CommandResult result = Run({"--input=" + graph_, "--certify"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  const auto& certificate = json["certificate"];
  EXPECT_EQ(certificate["optimal"], true);
  EXPECT_LE(certificate["relative_suboptimality"], 1e-6);
  EXPECT_EQ(certificate["cost"], json["final_cost"]);
  EXPECT_EQ(certificate["problem"], "least squares of all 4 edges");
}

TEST_F(OptimizeGraph, LeavesALocalMinimumForTheCertifiedOptimum) {
  const std::string ring = folder_.FileWith("ring.g2o", WoundRing());
  const std::string output = folder_.Path("out.g2o");
  const CommandResult result =
      Run({"--input=" + ring, "--output=" + output, "--loss=none", "--init=keep", "--certify"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["certificate"]["optimal"], true);
  EXPECT_LT(json["final_cost"], 1e-6);
  EXPECT_GT(json["certificate"]["given_cost"], 100.0);
  std::ifstream file(output);
  EXPECT_EQ(backend::GraphCost(backend::ReadG2o(file, output)), json["final_cost"]);
}

TEST_F(OptimizeGraph, SaysWhenPosesAreNotProvedToBeOptimal) {
  const std::string ring = folder_.FileWith("ring.g2o", WoundRing());
  const std::string output = folder_.Path("out.g2o");
  const CommandResult result = Run({"--input=" + ring, "--output=" + output, "--loss=none",
                                    "--init=keep", "--certify", "--nocertify_descend"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, StartsWith("optimize_graph: undecided: "));
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["certificate"]["optimal"], false);
  EXPECT_LT(json["certificate"]["smallest_eigenvalue"], 0.0);
  EXPECT_TRUE(std::filesystem::exists(output));
}

TEST_F(OptimizeGraph, SaysInOneLineWhatIsWrong) {
  const std::string broken = folder_.FileWith("broken.g2o", "VERTEX_SE2 0 0 0\n");
  EXPECT_THAT(ErrorOf({}), HasSubstr("--input=FILE is missing"));
  EXPECT_THAT(ErrorOf({"--input=" + broken}), HasSubstr("broken.g2o:1: expected a vertex"));
  EXPECT_THAT(ErrorOf({"--input=" + graph_, "--backend=nope"}), HasSubstr("no back end 'nope'"));
  EXPECT_THAT(ErrorOf({"--input=" + graph_, "--loss=hubert"}), HasSubstr("expected a loss out of"));
  EXPECT_THAT(ErrorOf({"--input=" + graph_, "--init=north"}),
              HasSubstr("expected an initialization out of"));
  EXPECT_THAT(ErrorOf({"--input=" + graph_, "--spa_solver=fast"}),
              HasSubstr("setting solver: expected one of block"));
}

TEST_F(OptimizeGraph, RefusesOneFileForTwoOutputs) {
  const std::string output = folder_.Path("out");
  EXPECT_THAT(ErrorOf({"--input=" + graph_, "--output=" + output,
                       "--covariances=" + folder_.Path("./out")}),
              HasSubstr("is the file of two outputs"));
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(OptimizeGraph, RefusesToReplaceItsInputBySomethingElse) {
  EXPECT_THAT(ErrorOf({"--input=" + graph_, "--covariances=" + graph_}), HasSubstr("is the input"));
  EXPECT_EQ(Run({"--input=" + graph_, "--output=" + graph_}).status, 0);
}

TEST_F(OptimizeGraph, LeavesNoOutputBehindAFailure) {
  const std::string output = folder_.Path("new/out.g2o");
  ErrorOf({"--input=" + graph_, "--output=" + output, "--spa_max_nonmonotonic_steps=-1"});
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("new")));
}

}  // namespace
}  // namespace gmapping_spa::apps
