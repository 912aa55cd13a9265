// SPDX-License-Identifier: BSD-3-Clause
// What real files hold besides the records of .g2o.
#include "backend/graph/g2o_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "backend/cost/graph_cost.h"
#include "tests/message_of.h"

namespace gmapping_spa::backend::g2o_reader_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

constexpr char kGraph[] =
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.5\nVERTEX_SE2 2 2 1 1\n"
    "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n";

PoseGraph Read(const std::string& text, G2oRemarks* remarks = nullptr) {
  std::istringstream in(text);
  return ReadG2o(in, "graph.g2o", {}, remarks);
}

std::string Text(const PoseGraph& graph) {
  std::ostringstream out;
  WriteG2o(graph, out);
  return out.str();
}

struct LeftOut {
  const char* name;
  const char* record;
  const char* remark;
};

class LeavesOut : public testing::TestWithParam<LeftOut> {};

// The graph is as without the record, and the remark counts it; strict readers refuse it.
TEST_P(LeavesOut, WithARemark) {
  G2oRemarks remarks;
  const std::string text = std::string(kGraph) + GetParam().record + "\n";
  EXPECT_EQ(Text(Read(text, &remarks)), Text(Read(kGraph)));
  EXPECT_THAT(remarks, ElementsAre(Pair(HasSubstr(GetParam().remark), 1)));
  std::istringstream in(text);
  EXPECT_THAT(MessageOf([&] { ReadG2o(in, "graph.g2o", {.strict = true}); }),
              AllOf(HasSubstr("graph.g2o:6: expected nothing that is left out"),
                    HasSubstr(GetParam().remark)));
}

INSTANTIATE_TEST_SUITE_P(
    G2oReader, LeavesOut,
    testing::Values(LeftOut{"SelfEdge", "EDGE_SE2 1 1 1 0 0 1 0 0 1 0 1", "to itself"},
                    LeftOut{"Indefinite", "EDGE_SE2 0 2 1 0 0 1 2 0 1 0 1", "semidefinite"},
                    LeftOut{"Zero", "EDGE_SE2 0 2 1 0 0 0 0 0 0 0 0", "zero"},
                    LeftOut{"IndefinitePrior", "EDGE_PRIOR_SE2 0 1 0 0 1 2 0 1 0 1",
                            "semidefinite"},
                    LeftOut{"Switch", "VERTEX_SWITCH 0 1", "VERTEX_SWITCH"},
                    LeftOut{"SwitchPrior", "EDGE_SWITCH_PRIOR 0 1 1", "EDGE_SWITCH_PRIOR"},
                    LeftOut{"Equivalence", "EQUIV 0 2", "EQUIV"}),
    [](const auto& test) { return test.param.name; });

TEST(G2oReader, ParametersOfSensorsDoNotMoveEdgesBetweenVertices) {
  for (const char* record : {"PARAMS_SE2OFFSET 0 0 0 0\n", "PARAMS_SE2OFFSET 3 0.1 -2 0.5\n",
                             "PARAMS_CAMERACALIB 1 0 0 0 0 0 0 1 500 500 320 240\n"}) {
    G2oRemarks remarks;
    EXPECT_EQ(Text(Read(std::string(record) + kGraph, &remarks)), Text(Read(kGraph)));
    EXPECT_THAT(remarks, IsEmpty());
  }
}

TEST(G2oReader, LinesEndAsOnAnySystem) {
  std::string windows, macintosh;
  for (const char c : std::string(kGraph)) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    macintosh += c == '\n' ? '\r' : c;
  }
  EXPECT_EQ(Text(Read(windows)), Text(Read(kGraph)));
  EXPECT_EQ(Text(Read(macintosh)), Text(Read(kGraph)));
  EXPECT_THAT(MessageOf([&] { Read(macintosh + "\rBAD"); }), HasSubstr("graph.g2o:7:"));
}

TEST(G2oReader, KnowsGtsamsNamesOfTorosRecords) {
  const std::string fields = " 0 1 1 2 0.5 1 0.1 2 3 0.2 0.3\n",
                    vertices = "VERTEX2 0 0 0 0\nVERTEX2 1 1 1 1\n";
  const std::string toro = Text(Read(vertices + "EDGE2" + fields));
  EXPECT_EQ(Text(Read("VERTEX 0 0 0 0\nVERTEX 1 1 1 1\nEDGE" + fields)), toro);
  EXPECT_EQ(Text(Read(vertices + "ODOMETRY" + fields)), toro);
}

TEST(G2oReader, TakesVertigosClosuresForPlainOnesAndSaysSo) {
  const std::string plain = Text(Read(std::string(kGraph) + "EDGE_SE2 0 2 1 2 3 4 0 0 5 0 6\n"));
  for (const char* record : {"EDGE_SE2_SWITCHABLE 0 2 7 1 2 3 4 0 0 5 0 6\n",
                             "EDGE_SE2_MAXMIX 0 2 1e-12 1 2 3 4 0 0 5 0 6\n"}) {
    G2oRemarks remarks;
    EXPECT_EQ(Text(Read(std::string(kGraph) + record, &remarks)), plain);
    EXPECT_THAT(remarks, ElementsAre(Pair(HasSubstr("taken for EDGE_SE2"), 1)));
  }
}

TEST(G2oReader, KeepsInformationThatIsMissingInADirection) {
  const PoseGraph graph = Read(std::string(kGraph) + "EDGE_SE2 0 2 1 2 3 4 0 0 5 0 0\n");
  ASSERT_EQ(graph.edges.size(), 3u);
  EXPECT_EQ(graph.edges[2].information(2, 2), 0.0);
}

TEST(G2oReader, APriorCostsWhatG2oSays) {
  G2oRemarks remarks;
  // The error in the frame of the measurement, turned by a quarter: (2, -1, 0.25).
  const PoseGraph graph = Read(
      "VERTEX_SE2 7 0 3 1.8207963267948966\n"
      "EDGE_PRIOR_SE2 7 1 1 1.5707963267948966 10 1 2 20 3 30\n",
      &remarks);
  const Eigen::Vector3d error(2, 1, 0.25);
  Eigen::Matrix3d information;
  information << 10, 1, 2, 1, 20, 3, 2, 3, 30;
  EXPECT_NEAR(GraphCost(graph), 0.5 * error.dot(information * error), 1e-9);
  EXPECT_TRUE(graph.nodes.back().fixed);
  EXPECT_THAT(remarks, ElementsAre(Pair(HasSubstr("priors"), 1)));
}

TEST(G2oReader, APriorStaysALoopClosureWhenTheGraphIsWrittenAndReadBack) {
  for (const char* id : {"0", "2"}) {
    const PoseGraph graph =
        Read(std::string(kGraph) + "EDGE_PRIOR_SE2 " + id + " 1 1 0 10 0 0 10 0 10\n");
    const PoseGraph again = Read(Text(graph));
    ASSERT_EQ(again.edges.size(), graph.edges.size());
    for (std::size_t k = 0; k < graph.edges.size(); ++k) {
      EXPECT_EQ(again.edges[k].kind, graph.edges[k].kind) << id << " " << k;
    }
    EXPECT_EQ(graph.edges.back().kind, EdgeKind::kLoopClosure);
  }
}

TEST(G2oReader, APriorOfThePositionLeavesTheHeadingFree) {
  const PoseGraph graph = Read("VERTEX_SE2 7 3 4 2\nEDGE_PRIOR_SE2_XY 7 1 1 10 1 20\n");
  const Eigen::Vector2d error(2, 3);
  Eigen::Matrix2d information;
  information << 10, 1, 1, 20;
  EXPECT_DOUBLE_EQ(GraphCost(graph), 0.5 * error.dot(information * error));
}

TEST(G2oReader, ReadsIdsOf63Bits) {
  const PoseGraph graph = Read("VERTEX_SE2 8646911284551352321 0 0 0\n");
  EXPECT_EQ(graph.nodes[0].id, 8646911284551352321);
  EXPECT_THAT(MessageOf([] { Read("VERTEX_SE2 9223372036854775808 0 0 0\n"); }),
              HasSubstr("found '9223372036854775808'"));
}

}  // namespace
}  // namespace gmapping_spa::backend::g2o_reader_test
