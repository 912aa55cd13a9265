// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/stamps_io.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/message_of.h"

namespace gmapping_spa::backend::stamps_io_test {
namespace {

PoseGraph TwoNodes() { return {{{3, 976052857.33753, {}}, {-1, 0.1, {}}}, {}}; }

PoseGraph Read(const std::string& text) {
  std::istringstream in(text);
  PoseGraph graph = TwoNodes();
  ReadStamps(in, "graph.stamps", &graph);
  return graph;
}

std::string ErrorOf(const std::string& text) {
  return MessageOf([&] { Read(text); });
}

TEST(StampsIo, AreReadBackExactlyInAnyOrder) {
  std::ostringstream out;
  WriteStamps(TwoNodes(), out);
  EXPECT_EQ(out.str(), "3 976052857.33753\n-1 0.1\n");
  const PoseGraph graph = Read("# id stamp_s\n-1 5\n\n3 976052857.33753 # first\n");
  EXPECT_EQ(graph.nodes[0].stamp_s, 976052857.33753);
  EXPECT_EQ(graph.nodes[1].stamp_s, 5.0);
}

TEST(StampsIo, AFixedNodeMayHaveNone) {
  std::istringstream in("-1 5\n");
  PoseGraph graph = TwoNodes();
  graph.nodes[0].fixed = true;
  ReadStamps(in, "graph.stamps", &graph);
  EXPECT_EQ(graph.nodes[1].stamp_s, 5.0);
}

TEST(StampsIo, RejectsWithTheLine) {
  const std::string expected =
      "graph.stamps:2: expected an integer id and a finite stamp in s, found ";
  EXPECT_EQ(ErrorOf("3 1\nx 1\n"), expected + "'x 1'");
  EXPECT_EQ(ErrorOf("3 1\n-1 nan\n"), expected + "'-1 nan'");
  EXPECT_EQ(ErrorOf("3 1\n-1 1 1\n"), expected + "'-1 1 1'");
  EXPECT_EQ(ErrorOf("3 1\n-1\n"), expected + "'-1'");
  EXPECT_EQ(ErrorOf("3 1\n4 1\n"), "graph.stamps:2: expected the id of a node, found 4");
  EXPECT_EQ(ErrorOf("3 1\n3 1\n"),
            "graph.stamps:2: expected one stamp for each node, found a second one for 3");
  EXPECT_EQ(ErrorOf("3 1\n"), "graph.stamps: expected a stamp for each node, found none for -1");
}

}  // namespace
}  // namespace gmapping_spa::backend::stamps_io_test
