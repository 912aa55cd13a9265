// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/g2o_io.h"

#include <string_view>

#include "backend/graph/g2o_reader.h"
#include "backend/text.h"

namespace gmapping_spa::backend {
namespace {

void WriteNumber(double number, std::ostream& out) { out << ' ' << ShortestText(number); }

void WritePose(const SE2& pose, std::ostream& out) {
  for (const double number : {pose.x, pose.y, pose.theta}) WriteNumber(number, out);
}

}  // namespace

PoseGraph ReadG2o(std::istream& in, const std::string& name, const G2oOptions& options,
                  G2oRemarks* remarks) {
  G2oReader reader(name, options);
  for (std::string text; std::getline(in, text);) {
    std::string_view rest = text;
    if (rest.ends_with('\r')) rest.remove_suffix(1);
    // Files of old Macintoshes end lines with a carriage return alone.
    for (std::size_t end; (end = rest.find('\r')) != rest.npos; rest.remove_prefix(end + 1)) {
      reader.ReadLine(rest.substr(0, end));
    }
    reader.ReadLine(rest);
  }
  PoseGraph graph = reader.Finish();
  if (remarks != nullptr) *remarks = reader.remarks();
  return graph;
}

void WriteG2o(const PoseGraph& graph, std::ostream& out) {
  for (const Node& node : graph.nodes) {
    out << "VERTEX_SE2 " << std::to_string(node.id);
    WritePose(node.world_T_node, out);
    out << '\n';
  }
  for (const Node& node : graph.nodes) {
    if (node.fixed) out << "FIX " << std::to_string(node.id) << '\n';
  }
  for (const Edge& edge : graph.edges) {
    out << "EDGE_SE2 " << std::to_string(edge.i) << ' ' << std::to_string(edge.j);
    WritePose(edge.i_T_j, out);
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) WriteNumber(edge.information(row, column), out);
    }
    out << '\n';
  }
}

}  // namespace gmapping_spa::backend
