#include "backend/g2o_io.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "backend/graph_index.h"
#include "backend/initial_guess.h"

namespace gmapping_spa::backend {
namespace {

// A finite number, or nothing when `word` is not one.
template <typename Number>
std::optional<Number> ParseNumber(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  if (!std::isfinite(static_cast<double>(number))) return std::nullopt;
  return number;
}

// Splits a line into its words.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  // The next word; empty at the end of the line.
  std::string_view Next() {
    constexpr std::string_view kSpace = " \t\r\v\f";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpace), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kSpace));
    rest_.remove_prefix(word.size());
    return word;
  }

  template <typename Number>
  std::optional<Number> NextNumber() {
    return ParseNumber<Number>(Next());
  }

  bool AtEnd() { return Next().empty(); }

 private:
  std::string_view rest_;
};

// A mention of a node, to be checked when all nodes are known.
struct Mention {
  std::int64_t id;
  int line;
};

class G2oReader {
 public:
  explicit G2oReader(const std::string& name) : name_(name) {}

  void ReadLine(const std::string& line) {
    ++line_;
    Words words(line);
    const std::string_view tag = words.Next();
    if (tag.empty() || tag[0] == '#') return;
    if (tag == "VERTEX_SE2" || tag == "VERTEX2") {
      ReadVertex(words);
    } else if (tag == "EDGE_SE2") {
      ReadEdge(words, {{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}});
    } else if (tag == "EDGE2") {
      ReadEdge(words, {{{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}}});
    } else if (tag == "FIX") {
      ReadFix(words);
    } else {
      Fail("expected a VERTEX_SE2, EDGE_SE2, FIX, VERTEX2 or EDGE2 record");
    }
  }

  PoseGraph Finish() {
    const bool without_vertices = graph_.nodes.empty();
    if (without_vertices) MakeNodes();
    for (const Mention& mention : mentions_) {
      line_ = mention.line;
      if (!position_.contains(mention.id)) {
        Fail("expected a vertex with the id " + std::to_string(mention.id) + " in the file");
      }
    }
    for (const std::int64_t id : fixed_) graph_.nodes[position_.at(id)].fixed = true;
    if (without_vertices) PlaceNodes();
    return std::move(graph_);
  }

 private:
  // Row and column of each of the six numbers of an information matrix.
  using InformationOrder = std::array<std::array<int, 2>, 6>;

  [[noreturn]] void Fail(const std::string& expectation) const {
    throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": " + expectation);
  }

  void ReadVertex(Words& words) {
    const auto id = words.NextNumber<std::int64_t>();
    const auto x = words.NextNumber<double>(), y = words.NextNumber<double>(),
               theta = words.NextNumber<double>();
    if (!id || !x || !y || !theta || !words.AtEnd()) {
      Fail("expected a vertex as an integer id and three finite numbers x y theta");
    }
    if (!position_.emplace(*id, graph_.nodes.size()).second) {
      Fail("expected one vertex for each id, found a second one for " + std::to_string(*id));
    }
    graph_.nodes.push_back({*id, 0.0, {*x, *y, *theta}});
  }

  void ReadEdge(Words& words, const InformationOrder& order) {
    const auto i = words.NextNumber<std::int64_t>(), j = words.NextNumber<std::int64_t>();
    std::array<double, 9> numbers{};
    bool complete = i && j;
    for (double& number : numbers) {
      const auto parsed = words.NextNumber<double>();
      complete = complete && parsed;
      number = parsed.value_or(0.0);
    }
    if (!complete || !words.AtEnd()) {
      Fail("expected an edge as two integer ids, x y theta and six information entries, finite");
    }
    if (*i == *j) Fail("expected an edge between two different vertices");
    Edge edge{*i, *j, {numbers[0], numbers[1], numbers[2]}};
    for (int k = 0; k < 6; ++k) {
      const auto [row, column] = order[k];
      edge.information(row, column) = edge.information(column, row) = numbers[3 + k];
    }
    if (edge.information.llt().info() != Eigen::Success) {
      Fail("expected a positive definite information matrix");
    }
    // Differences of 64-bit ids may overflow; neighbours do not.
    const bool consecutive = (*i < *j && *i + 1 == *j) || (*j < *i && *j + 1 == *i);
    edge.kind = consecutive ? EdgeKind::kOdometry : EdgeKind::kLoopClosure;
    graph_.edges.push_back(edge);
    mentions_.push_back({*i, line_});
    mentions_.push_back({*j, line_});
  }

  void ReadFix(Words& words) {
    std::string_view word = words.Next();
    do {
      const auto id = ParseNumber<std::int64_t>(word);
      if (!id) Fail("expected FIX with integer ids");
      mentions_.push_back({*id, line_});
      fixed_.push_back(*id);
      word = words.Next();
    } while (!word.empty());
  }

  void MakeNodes() {
    std::vector<std::int64_t> ids;
    for (const Edge& edge : graph_.edges) {
      ids.push_back(edge.i);
      ids.push_back(edge.j);
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    for (const std::int64_t id : ids) {
      position_.emplace(id, graph_.nodes.size());
      graph_.nodes.push_back({id, 0.0, {}});
    }
  }

  void PlaceNodes() {
    std::vector<SE2> poses = PosesOf(graph_);
    InitializeFromOdometry(graph_, IndexGraph(graph_), &poses);
    for (std::size_t k = 0; k < poses.size(); ++k) graph_.nodes[k].world_T_node = poses[k];
  }

  const std::string& name_;
  int line_ = 0;
  PoseGraph graph_;
  std::unordered_map<std::int64_t, std::size_t> position_;  // of a node, by id
  std::vector<Mention> mentions_;
  std::vector<std::int64_t> fixed_;
};

// Writes a space and the shortest text that reads back as the same number, in any locale.
template <typename Number>
void WriteNumber(Number number, std::ostream& out) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof(text), number).ptr;
  out << ' ' << std::string_view(text, end - text);
}

void WritePose(const SE2& pose, std::ostream& out) {
  for (const double number : {pose.x, pose.y, pose.theta}) WriteNumber(number, out);
}

}  // namespace

PoseGraph ReadG2o(std::istream& in, const std::string& name) {
  G2oReader reader(name);
  for (std::string line; std::getline(in, line);) reader.ReadLine(line);
  return reader.Finish();
}

void WriteG2o(const PoseGraph& graph, std::ostream& out) {
  for (const Node& node : graph.nodes) {
    out << "VERTEX_SE2";
    WriteNumber(node.id, out);
    WritePose(node.world_T_node, out);
    out << '\n';
  }
  for (const Node& node : graph.nodes) {
    if (!node.fixed) continue;
    out << "FIX";
    WriteNumber(node.id, out);
    out << '\n';
  }
  for (const Edge& edge : graph.edges) {
    out << "EDGE_SE2";
    WriteNumber(edge.i, out);
    WriteNumber(edge.j, out);
    WritePose(edge.i_T_j, out);
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) WriteNumber(edge.information(row, column), out);
    }
    out << '\n';
  }
}

}  // namespace gmapping_spa::backend
