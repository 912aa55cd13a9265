// SPDX-License-Identifier: BSD-3-Clause
// optimize_graph --covariances.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/built_back_ends.h"
#include "tests/command_error.h"
#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps::covariances_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class OptimizeGraphCovariances : public ::testing::Test {
 protected:
  struct Table {
    std::string comment, names;
    std::vector<std::vector<double>> rows;
    nlohmann::json json;
  };

  // A line of nodes with ids in no order, measured exactly, and a piece of its own.
  TemporaryFolder folder_;
  std::string graph_ = folder_.FileWith("line.g2o",
                                        "VERTEX_SE2 7 0 0 1.5707963267948966\n"
                                        "VERTEX_SE2 3 0 2 1.5707963267948966\n"
                                        "VERTEX_SE2 5 0 5 1.5707963267948966\n"
                                        "VERTEX_SE2 20 9 9 0\n"
                                        "VERTEX_SE2 21 10 9 0\n"
                                        "EDGE_SE2 7 3 2 0 0 4 0 0 25 0 100\n"
                                        "EDGE_SE2 3 5 3 0 0 4 0 0 25 0 100\n"
                                        "EDGE_SE2 20 21 1 0 0 1 0 0 1 0 1\n");
  std::string csv_ = folder_.Path("covariances.csv");

  Table Run(std::vector<std::string> flags) const {
    flags.insert(flags.begin(), {OPTIMIZE_GRAPH, "--input=" + graph_, "--covariances=" + csv_});
    const CommandResult result = RunCommand(flags);
    EXPECT_EQ(result.status, 0) << result.err;
    Table table;
    table.json = nlohmann::json::parse(result.out)["covariances"];
    std::ifstream file(csv_);
    std::getline(file, table.comment);
    std::getline(file, table.names);
    for (std::string line; std::getline(file, line);) {
      std::istringstream words(line);
      std::vector<double>& row = table.rows.emplace_back();
      for (std::string word; std::getline(words, word, ',');) row.push_back(std::stod(word));
    }
    return table;
  }

  std::string ErrorOf(const std::string& input, const std::string& of) const {
    const std::string error =
        gmapping_spa::ErrorOf({OPTIMIZE_GRAPH, "--input=" + input, "--covariances=" + csv_,
                               "--covariances_of=" + of, "--output=" + folder_.Path("out.g2o")});
    EXPECT_FALSE(std::filesystem::exists(csv_));
    EXPECT_FALSE(std::filesystem::exists(folder_.Path("out.g2o")));
    return error;
  }
};

TEST_F(OptimizeGraphCovariances, TellsThoseOfAllNodesInTheWorldFrame) {
  for (const char* backend : Built({"spa", "ceres", "none"})) {
    const Table table = Run({std::string("--backend=") + backend});
    EXPECT_THAT(table.comment, AllOf(HasSubstr("world frame"), HasSubstr("m^2, m rad, rad^2"),
                                     HasSubstr("from 3 of 3 edges")));
    EXPECT_EQ(table.names,
              "node,held_node,x_m,y_m,theta_rad,cov_xx,cov_xy,cov_xtheta,cov_yy,cov_ytheta,"
              "cov_thetatheta");
    ASSERT_EQ(table.rows.size(), 5u);
    EXPECT_THAT(table.rows[0], ElementsAre(7, 7, 0, 0, 1.5707963267948966, 0, 0, 0, 0, 0, 0));
    // The line points up: along is y. After 2 m and 3 m more: 1/25 + 1/25 + 3^2 / 100 across.
    const std::vector<double>& row = table.rows[2];
    EXPECT_EQ(row[0], 5);
    EXPECT_EQ(row[1], 7);
    EXPECT_NEAR(row[5], 0.17, 1e-12);   // x x
    EXPECT_NEAR(row[7], -0.03, 1e-12);  // x theta
    EXPECT_NEAR(row[8], 0.5, 1e-12);    // y y
    EXPECT_NEAR(row[10], 0.02, 1e-12);  // theta theta
    EXPECT_EQ(table.rows[4][1], 20);
    EXPECT_EQ(table.json["rows"], 5);
    EXPECT_EQ(table.json["components"], 2);
    EXPECT_EQ(table.json["computed_by"], std::string(backend) == "none" ? "program" : "back end");
  }
}

TEST_F(OptimizeGraphCovariances, TellsThoseOfChosenNodesAndPairs) {
  const Table nodes = Run({"--covariances_of=5,21"});
  ASSERT_EQ(nodes.rows.size(), 2u);
  EXPECT_EQ(nodes.rows[0][0], 5);
  EXPECT_EQ(nodes.rows[1][0], 21);
  const Table pairs = Run({"--covariances_of=3:5,5:3"});
  EXPECT_THAT(pairs.comment, HasSubstr("frame of node i"));
  EXPECT_THAT(pairs.names, ::testing::StartsWith("i,j,x_m,y_m,theta_rad,cov_xx"));
  ASSERT_EQ(pairs.rows.size(), 2u);
  // That of the edge, in its frame.
  EXPECT_NEAR(pairs.rows[0][2], 3.0, 1e-12);
  EXPECT_NEAR(pairs.rows[0][5], 0.25, 1e-12);
  EXPECT_NEAR(pairs.rows[0][8], 0.04, 1e-12);
  EXPECT_NEAR(pairs.rows[0][10], 0.01, 1e-12);
  // The other way round, the heading of 5 moves 3 sideways.
  EXPECT_NEAR(pairs.rows[1][8], 0.04 + 9 * 0.01, 1e-12);
  ASSERT_EQ(pairs.rows[0].size(), 20u);
  EXPECT_NEAR(pairs.rows[0][11], 0.04, 1e-12);  // x of 3 and x of 5, in the world
}

TEST_F(OptimizeGraphCovariances, RestOnTheEdgesThatTheLossLeaves) {
  std::string text;
  for (int k = 0; k < 8; ++k) {
    text += "EDGE_SE2 " + std::to_string(k) + ' ' + std::to_string(k + 1) +
            " 1 0 0 100 0 0 100 0 400\n";
  }
  const std::string closures =
      "EDGE_SE2 0 4 4 0 0 100 0 0 100 0 400\n"
      "EDGE_SE2 4 8 4 0 0 100 0 0 100 0 400\n";
  const std::string wrong = "EDGE_SE2 1 7 -30 20 1 100 0 0 100 0 400\n";
  graph_ = folder_.FileWith("good.g2o", text + closures);
  const Table good = Run({});
  graph_ = folder_.FileWith("wrong.g2o", text + closures + wrong);
  const Table robust = Run({});
  EXPECT_THAT(robust.comment, HasSubstr("from 10 of 11 edges, weighted as the loss mixture"));
  for (std::size_t k = 0; k < good.rows.size(); ++k) {
    EXPECT_NEAR(robust.rows[k][5], good.rows[k][5], 1e-3 * good.rows[k][5]);
  }
}

TEST_F(OptimizeGraphCovariances, SaysInOneLineWhenThereAreNone) {
  const std::string singular = folder_.FileWith("singular.g2o",
                                                "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
                                                "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 0\n");
  EXPECT_THAT(ErrorOf(singular, "all"), HasSubstr("the covariances do not exist"));
  EXPECT_THAT(ErrorOf(graph_, "5:20"),
              HasSubstr("nothing connects the nodes 5 and 20: their relative pose has no "));
  EXPECT_THAT(ErrorOf(graph_, "3,6"), HasSubstr("the graph has no node 6"));
  EXPECT_THAT(ErrorOf(graph_, "3,5:7"), HasSubstr("--covariances_of: expected all, ids of nodes"));
  EXPECT_THAT(ErrorOf(graph_, ""), HasSubstr("found ''"));
  EXPECT_THAT(ErrorOf(graph_, "3:"), HasSubstr("found '3:'"));
}

}  // namespace
}  // namespace gmapping_spa::apps::covariances_test
