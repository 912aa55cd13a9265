// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/g2o_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>

#include "tests/message_of.h"

namespace gmapping_spa::backend {
namespace {

PoseGraph Read(const std::string& text) {
  std::istringstream in(text);
  return ReadG2o(in, "graph.g2o");
}

std::string Write(const PoseGraph& graph) {
  std::ostringstream out;
  WriteG2o(graph, out);
  return out.str();
}

std::string ErrorOf(const std::string& text) {
  return MessageOf([&] { Read(text); });
}

constexpr char kTwoNodes[] = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n";

TEST(ReadG2o, ReadsVerticesEdgesAndFixedNodesInAnyOrder) {
  const PoseGraph graph = Read(
      "# a comment\r\n\n"
      "FIX 7 3\r\n"
      "EDGE_SE2 7 3 1 -2e-1 +.5 1 0.1 0.2 2 0.3 3\n"
      "VERTEX_SE2\t3 1.5 2 -3\n"
      "VERTEX_SE2 7 0 0 0");
  ASSERT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(graph.nodes[0].id, 3);
  EXPECT_EQ(graph.nodes[0].world_T_node, (SE2{1.5, 2, -3}));
  EXPECT_TRUE(graph.nodes[0].fixed);
  EXPECT_TRUE(graph.nodes[1].fixed);
  ASSERT_EQ(graph.edges.size(), 1u);
  EXPECT_EQ(graph.edges[0].i, 7);
  EXPECT_EQ(graph.edges[0].j, 3);
  EXPECT_EQ(graph.edges[0].i_T_j, (SE2{1, -0.2, 0.5}));
  Eigen::Matrix3d information;
  information << 1, 0.1, 0.2, 0.1, 2, 0.3, 0.2, 0.3, 3;
  EXPECT_EQ(graph.edges[0].information, information);
}

TEST(ReadG2o, KnowsTorosOrderOfTheInformation) {
  const PoseGraph graph =
      Read("VERTEX2 0 0 0 0\nVERTEX2 1 1 0 0\nEDGE2 0 1 1 0 0 1 0.1 2 3 0.2 0.3");
  Eigen::Matrix3d information;
  information << 1, 0.1, 0.2, 0.1, 2, 0.3, 0.2, 0.3, 3;
  EXPECT_EQ(graph.edges.at(0).information, information);
}

TEST(ReadG2o, TakesEdgesBetweenConsecutiveIdsForOdometry) {
  const PoseGraph graph = Read(
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 2 1 -1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 0 2 2 0 0 1 0 0 1 0 1\n");
  EXPECT_EQ(graph.edges[0].kind, EdgeKind::kOdometry);
  EXPECT_EQ(graph.edges[1].kind, EdgeKind::kOdometry);
  EXPECT_EQ(graph.edges[2].kind, EdgeKind::kLoopClosure);
}

TEST(ReadG2o, NeighborsAmongTheIdsThatExistAreTheChain) {
  const PoseGraph graph = Read(
      "VERTEX_SE2 9 3 0 0\nVERTEX_SE2 0 0 0 0\nVERTEX_SE2 4 1 0 0\n"
      "EDGE_SE2 0 4 1 0 0 1 0 0 1 0 1\nEDGE_SE2 9 4 -1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 0 9 2 0 0 1 0 0 1 0 1\n");
  EXPECT_EQ(graph.edges[0].kind, EdgeKind::kOdometry);
  EXPECT_EQ(graph.edges[1].kind, EdgeKind::kOdometry);
  EXPECT_EQ(graph.edges[2].kind, EdgeKind::kLoopClosure);
}

TEST(ReadG2o, SkipsAByteOrderMarkAndCommentsAfterFields) {
  const PoseGraph graph = Read(
      "\xef\xbb\xbfVERTEX_SE2 0 0 0 0 # start\nVERTEX_SE2 1 1 0 0# no blank\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1 #odometry\nFIX 0 # 1\n");
  EXPECT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(graph.edges.size(), 1u);
  EXPECT_TRUE(graph.nodes[0].fixed);
  EXPECT_FALSE(graph.nodes[1].fixed);
}

TEST(ReadG2o, PlacesNodesOfAFileWithoutVerticesAlongTheOdometryChain) {
  // The loop closure 0 -> 2 contradicts the odometry, which wins.
  const PoseGraph graph = Read(
      "EDGE_SE2 0 2 9 9 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 0 1 1 0 1.5707963267948966 1 0 0 1 0 1\n");
  ASSERT_EQ(graph.nodes.size(), 3u);
  EXPECT_EQ(graph.nodes[0].world_T_node, SE2{});
  EXPECT_EQ(graph.nodes[1].world_T_node, (SE2{1, 0, 1.5707963267948966}));
  EXPECT_NEAR(graph.nodes[2].world_T_node.x, 1, 1e-15);
  EXPECT_NEAR(graph.nodes[2].world_T_node.y, 1, 1e-15);
}

TEST(ReadG2o, TakesAnEmptyFileForAnEmptyGraph) {
  const PoseGraph graph = Read("");
  EXPECT_TRUE(graph.nodes.empty());
  EXPECT_TRUE(graph.edges.empty());
}

TEST(ReadG2o, NamesTheLineOfWhatItCannotRead) {
  const std::string nodes = kTwoNodes;
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {nodes + "VERTEX_XY 1 0 0",
       "graph.g2o:3: expected a VERTEX_SE2, EDGE_SE2, FIX, VERTEX2 or EDGE2 record, found "
       "'VERTEX_XY': landmarks are not supported"},
      {nodes + "EDGE_SE2_XY 0 1 1 0 1 0 1",
       "graph.g2o:3: expected a VERTEX_SE2, EDGE_SE2, FIX, VERTEX2 or EDGE2 record, found "
       "'EDGE_SE2_XY': landmarks are not supported"},
      {"VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1",
       "graph.g2o:1: expected a VERTEX_SE2, EDGE_SE2, FIX, VERTEX2 or EDGE2 record, found "
       "'VERTEX_SE3:QUAT': graphs in 3D are not supported"},
      {"VERTEX_SE2 0 0 0",
       "graph.g2o:1: expected a vertex as an integer id and three finite numbers x y theta, found "
       "the "
       "end of the line"},
      {"VERTEX_SE2 0 0 nan 0",
       "graph.g2o:1: expected a vertex as an integer id and three finite numbers x y theta, found "
       "'nan'"},
      {"VERTEX_SE2 0 0 0 0 0",
       "graph.g2o:1: expected a vertex as an integer id and three finite numbers x y theta, found "
       "'0'"},
      {"VERTEX_SE2 0.5 0 0 0",
       "graph.g2o:1: expected a vertex as an integer id and three finite numbers x y theta, found "
       "'0.5'"},
      {nodes + "\nVERTEX_SE2 1 0 0 0",
       "graph.g2o:4: expected one vertex for each id, found a second one for 1"},
      {nodes + "EDGE_SE2 0 1 1 0 0 1 0 0 1 0",
       "graph.g2o:3: expected an edge as two integer ids, x y theta and six information entries, "
       "finite, found the end of the line"},
      {nodes + "EDGE_SE2 0 1 1 0 inf 1 0 0 1 0 1",
       "graph.g2o:3: expected an edge as two integer ids, x y theta and six information entries, "
       "finite, found 'inf'"},
      {nodes + "EDGE_SE2 0 1 1 0 1e999 1 0 0 1 0 1",
       "graph.g2o:3: expected an edge as two integer ids, x y theta and six information entries, "
       "finite, found '1e999'"},
      {"EDGE_SE2 0 5 1 0 0 1 0 0 1 0 1\n" + nodes,
       "graph.g2o:1: expected a vertex with the id 5 in the file"},
      {nodes + "FIX 2", "graph.g2o:3: expected a vertex with the id 2 in the file"},
      {nodes + "FIX", "graph.g2o:3: expected FIX with integer ids, found the end of the line"},
      {nodes + "FIX 1 x", "graph.g2o:3: expected FIX with integer ids, found 'x'"},
  };
  for (const auto& c : cases) EXPECT_EQ(ErrorOf(c.text), c.message) << c.text;
}

TEST(WriteG2o, IsReadBackExactly) {
  PoseGraph graph;
  graph.nodes = {{-4, 0, {0.1, 1.0 / 3.0, -3.0000000000000004}},
                 {std::numeric_limits<std::int64_t>::max(), 0, {1e300, -5e-324, 1e-17}, true},
                 {0, 0, {std::nextafter(1e6, 2e6), -0.0, 3}}};
  Eigen::Matrix3d information;
  information << 1.0 / 7, 0.1, 0.01, 0.1, 2, 0.3, 0.01, 0.3, 1e10 / 3;
  graph.edges = {{0, -4, {1.0 / 9, 2e-9, 3}, information, EdgeKind::kOdometry},
                 {-4, graph.nodes[1].id, {0, 0, 0}, information, EdgeKind::kLoopClosure}};
  const PoseGraph again = Read(Write(graph));
  ASSERT_EQ(again.nodes.size(), graph.nodes.size());
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    EXPECT_EQ(again.nodes[k].id, graph.nodes[k].id);
    EXPECT_EQ(again.nodes[k].world_T_node, graph.nodes[k].world_T_node);
    EXPECT_EQ(again.nodes[k].fixed, graph.nodes[k].fixed);
  }
  ASSERT_EQ(again.edges.size(), graph.edges.size());
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    EXPECT_EQ(again.edges[k].i, graph.edges[k].i);
    EXPECT_EQ(again.edges[k].j, graph.edges[k].j);
    EXPECT_EQ(again.edges[k].i_T_j, graph.edges[k].i_T_j);
    EXPECT_EQ(again.edges[k].information, graph.edges[k].information);
    EXPECT_EQ(again.edges[k].kind, graph.edges[k].kind);
  }
  EXPECT_EQ(Write(again), Write(graph));
}

}  // namespace
}  // namespace gmapping_spa::backend
