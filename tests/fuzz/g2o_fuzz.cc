// SPDX-License-Identifier: BSD-3-Clause
// Pose graphs: .g2o, TORO's .graph. What was read is written and read back the same.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "backend/graph/g2o_io.h"
#include "tests/fuzz/contract.h"

namespace gmapping_spa::fuzz {
namespace {

using backend::Edge;
using backend::Node;
using backend::PoseGraph;

bool Same(const Node& a, const Node& b) {
  return a.id == b.id && a.fixed == b.fixed && a.world_T_node == b.world_T_node;
}

bool Same(const Edge& a, const Edge& b) {
  return a.i == b.i && a.j == b.j && a.i_T_j == b.i_T_j && a.information == b.information;
}

void CheckRoundTrip(const PoseGraph& graph) {
  std::stringstream file;
  backend::WriteG2o(graph, file);
  const PoseGraph again = backend::ReadG2o(file, "again");
  bool same = graph.nodes.size() == again.nodes.size() && graph.edges.size() == again.edges.size();
  for (std::size_t k = 0; same && k < graph.nodes.size(); ++k) {
    same = Same(graph.nodes[k], again.nodes[k]);
  }
  for (std::size_t k = 0; same && k < graph.edges.size(); ++k) {
    same = Same(graph.edges[k], again.edges[k]);
  }
  if (!same) Break("expected the graph that was written, found another one");
}

}  // namespace
}  // namespace gmapping_spa::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  const std::string text = fuzz::TextOf(data, size);
  backend::PoseGraph graph;
  const bool reads = fuzz::ReadsOrRefuses([&] {
    std::istringstream in(text);
    graph = backend::ReadG2o(in, "graph.g2o");
  });
  if (reads) {
    try {
      fuzz::CheckRoundTrip(graph);
    } catch (const std::exception& error) {
      fuzz::Break(std::string("what was written cannot be read: ") + error.what());
    }
  }
  fuzz::ReadsOrRefuses([&] {
    std::istringstream in(text);
    backend::ReadG2o(in, "graph.g2o", {.strict = true});
  });
  return 0;
}
