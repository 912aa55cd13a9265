// SPDX-License-Identifier: BSD-3-Clause
// Stamps of the nodes of a graph. What was read can be written and read back.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "backend/graph/stamps_io.h"
#include "tests/fuzz/contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  backend::PoseGraph graph{{{0, 0.0, {}}, {1, 0.0, {}}}, {}};
  const bool reads = fuzz::ReadsOrRefuses([&] {
    std::istringstream in(fuzz::TextOf(data, size));
    backend::ReadStamps(in, "graph.stamps", &graph);
  });
  if (!reads) return 0;
  backend::PoseGraph again = graph;
  std::stringstream file;
  backend::WriteStamps(graph, file);
  backend::ReadStamps(file, "again", &again);
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    if (graph.nodes[k].stamp_s != again.nodes[k].stamp_s) {
      fuzz::Break("expected the stamps that were written, found others");
    }
  }
  return 0;
}
