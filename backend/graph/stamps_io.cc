// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/stamps_io.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "backend/text.h"

namespace gmapping_spa::backend {

void ReadStamps(std::istream& in, const std::string& name, PoseGraph* graph) {
  std::unordered_map<std::int64_t, std::size_t> position;
  for (std::size_t k = 0; k < graph->nodes.size(); ++k) position.emplace(graph->nodes[k].id, k);
  std::vector<std::optional<double>> stamps_s(graph->nodes.size());
  int number = 0;
  const auto fail = [&](const std::string& message) {
    throw std::runtime_error(name + ":" + std::to_string(number) + ": expected " + message);
  };
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string_view text = number == 1 ? WithoutByteOrderMark(line) : line;
    const std::vector<std::string_view> words = WordsOf(WithoutComment(text));
    if (words.empty()) continue;
    const auto id = ParseFinite<std::int64_t>(words[0]);
    const auto stamp_s = words.size() == 2 ? ParseFinite<double>(words[1]) : std::nullopt;
    if (!id || !stamp_s) fail("an integer id and a finite stamp in s, found " + Quoted(line));
    const auto found = position.find(*id);
    if (found == position.end()) fail("the id of a node, found " + std::to_string(*id));
    std::optional<double>& stamp = stamps_s[found->second];
    if (stamp) fail("one stamp for each node, found a second one for " + std::to_string(*id));
    stamp = stamp_s;
  }
  if (in.bad()) throw std::runtime_error(name + ": cannot be read");
  for (std::size_t k = 0; k < stamps_s.size(); ++k) {
    if (stamps_s[k] || graph->nodes[k].fixed) continue;
    throw std::runtime_error(name + ": expected a stamp for each node, found none for " +
                             std::to_string(graph->nodes[k].id));
  }
  for (std::size_t k = 0; k < stamps_s.size(); ++k) {
    if (stamps_s[k]) graph->nodes[k].stamp_s = *stamps_s[k];
  }
}

void WriteStamps(const PoseGraph& graph, std::ostream& out) {
  for (const Node& node : graph.nodes) {
    out << std::to_string(node.id) << ' ' << ShortestFixedText(node.stamp_s) << '\n';
  }
}

}  // namespace gmapping_spa::backend
