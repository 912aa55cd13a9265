#include "backend/graph/g2o_io.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "backend/graph/graph_index.h"
#include "backend/graph/initial_guess.h"
#include "backend/text.h"

namespace gmapping_spa::backend {
namespace {

// Splits a line into its words.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  // The next word; empty at the end of the line.
  std::string_view Next() { return TakeWord(&rest_); }

  template <typename Number>
  std::optional<Number> NextNumber() {
    return ParseFinite<Number>(Next());
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
    Words words(WithoutComment(line_ == 1 ? WithoutByteOrderMark(line) : line));
    const std::string_view tag = words.Next();
    if (tag.empty()) return;
    if (tag == "VERTEX_SE2" || tag == "VERTEX2") {
      ReadVertex(words);
    } else if (tag == "EDGE_SE2") {
      ReadEdge(words, {{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}});
    } else if (tag == "EDGE2") {
      ReadEdge(words, {{{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}}});
    } else if (tag == "FIX") {
      ReadFix(words);
    } else if (tag == "PARAMS_SE2OFFSET") {
      CheckOffset(words);
    } else {
      FailAtRecord(tag);
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
    TellChainFromClosures();
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

  [[noreturn]] void FailAtRecord(std::string_view tag) const {
    std::string reason;
    if (tag.find("XY") != tag.npos || tag.find("LANDMARK") != tag.npos) {
      reason = ": landmarks are not supported";
    } else if (tag.find("SE3") != tag.npos || tag.ends_with('3')) {
      reason = ": graphs in 3D are not supported";
    }
    Fail("expected a VERTEX_SE2, EDGE_SE2, FIX, VERTEX2 or EDGE2 record, found " + Quoted(tag) +
         reason);
  }

  // The offset of a sensor, which g2o applies to records that name it and are not supported here:
  // EDGE_SE2 is between the vertices themselves.
  void CheckOffset(Words& words) const {
    const bool id = words.NextNumber<std::int64_t>().has_value();
    const bool x = words.NextNumber<double>().has_value();
    const bool y = words.NextNumber<double>().has_value();
    const bool theta = words.NextNumber<double>().has_value();
    if (!id || !x || !y || !theta || !words.AtEnd()) {
      Fail("expected an offset as an integer id and three finite numbers x y theta");
    }
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
    graph_.edges.push_back(edge);
    mentions_.push_back({*i, line_});
    mentions_.push_back({*j, line_});
  }

  void ReadFix(Words& words) {
    std::string_view word = words.Next();
    do {
      const auto id = ParseFinite<std::int64_t>(word);
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

  // Neighbors in ascending order of the ids that exist are the robot's way: where nodes were
  // removed, the edge across the gap is as sure as the others.
  void TellChainFromClosures() {
    std::vector<std::int64_t> ids;
    for (const Node& node : graph_.nodes) ids.push_back(node.id);
    std::sort(ids.begin(), ids.end());
    const auto rank = [&](std::int64_t id) {
      return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
    };
    for (Edge& edge : graph_.edges) {
      const bool neighbors = std::abs(rank(edge.i) - rank(edge.j)) == 1;
      edge.kind = neighbors ? EdgeKind::kOdometry : EdgeKind::kLoopClosure;
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

void WriteNumber(double number, std::ostream& out) { out << ' ' << ShortestText(number); }

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
