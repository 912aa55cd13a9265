// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/g2o_reader.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>

#include "backend/graph/graph_index.h"
#include "backend/graph/initial_guess.h"
#include "backend/text.h"

namespace gmapping_spa::backend {
namespace {

constexpr char kEdgeFields[] =
    "expected an edge as two integer ids, x y theta and six information entries, finite";
constexpr char kPriorFields[] =
    "expected a prior as an integer id, x y theta and six information entries, finite";
constexpr char kPositionPriorFields[] =
    "expected a prior as an integer id, x y and three information entries, finite";

std::string QuotedOrEnd(std::string_view word) {
  return word.empty() ? "the end of the line" : Quoted(word);
}

}  // namespace

G2oReader::G2oReader(const std::string& name, const G2oOptions& options)
    : name_(name), options_(options) {}

void G2oReader::ReadLine(std::string_view line) {
  ++line_;
  std::string_view words = WithoutComment(line_ == 1 ? WithoutByteOrderMark(line) : line);
  const std::string_view tag = TakeWord(&words);
  if (tag.empty()) return;
  if (tag == "VERTEX_SE2" || tag == "VERTEX2" || tag == "VERTEX") {
    ReadVertex(words);
  } else if (tag == "EDGE_SE2") {
    ReadEdge(words, kG2oOrder, 0);
  } else if (tag == "EDGE2" || tag == "EDGE" || tag == "ODOMETRY") {
    ReadEdge(words, kToroOrder, 0);
  } else if (tag == "EDGE_SE2_SWITCHABLE" || tag == "EDGE_SE2_MAXMIX") {
    Remark(std::string(tag) + " records are taken for EDGE_SE2: --loss sees to wrong ones");
    ReadEdge(words, kG2oOrder, 1);
  } else if (tag == "EDGE_PRIOR_SE2") {
    ReadPrior(words);
  } else if (tag == "EDGE_PRIOR_SE2_XY") {
    ReadPositionPrior(words);
  } else if (tag == "FIX") {
    ReadFix(words);
  } else if (tag.starts_with("PARAMS_")) {
    // Of sensors, for records that name them: EDGE_SE2 is between the vertices themselves.
  } else if (tag == "VERTEX_SWITCH" || tag == "EDGE_SWITCH_PRIOR" || tag == "EQUIV") {
    Remark(std::string(tag) + " records are left out");
  } else {
    FailAtRecord(tag);
  }
}

PoseGraph G2oReader::Finish() {
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
  if (!priors_.empty()) AddPriors();
  if (without_vertices) PlaceNodes();
  return std::move(graph_);
}

void G2oReader::Fail(const std::string& expectation) const {
  throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": " + expectation);
}

void G2oReader::FailAtRecord(std::string_view tag) const {
  std::string reason;
  if (tag.find("XY") != tag.npos || tag.find("LANDMARK") != tag.npos || tag == "BR") {
    reason = ": landmarks are not supported";
  } else if (tag.find("SE3") != tag.npos || tag.ends_with('3')) {
    reason = ": graphs in 3D are not supported";
  }
  Fail("expected a VERTEX_SE2, EDGE_SE2, FIX, VERTEX2 or EDGE2 record, found " + Quoted(tag) +
       reason);
}

void G2oReader::Remark(const std::string& remark) {
  if (options_.strict) Fail("expected nothing that is left out or changed (--strict): " + remark);
  ++remarks_[remark];
}

std::int64_t G2oReader::TakeId(std::string_view* words, const char* expectation) const {
  const std::string_view word = TakeWord(words);
  const auto id = ParseFinite<std::int64_t>(word);
  if (!id) Fail(std::string(expectation) + ", found " + QuotedOrEnd(word));
  return *id;
}

std::vector<double> G2oReader::Numbers(std::string_view words, std::size_t count,
                                       const char* expectation) const {
  std::vector<double> numbers;
  for (std::string_view word = TakeWord(&words); !word.empty() || numbers.size() < count;
       word = TakeWord(&words)) {
    const auto number = ParseFinite<double>(word);
    if (!number || numbers.size() == count) {
      Fail(std::string(expectation) + ", found " + QuotedOrEnd(word));
    }
    numbers.push_back(*number);
  }
  return numbers;
}

// Information may be missing in a direction, but not negative.
bool G2oReader::IsInformation(const Eigen::Matrix3d& information) {
  constexpr double kRounding = 1e-9;
  const double minor = information.topLeftCorner<2, 2>().determinant();
  if (information(0, 0) > 0.0 && minor > 0.0 && information.determinant() > 0.0) return true;
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information, Eigen::EigenvaluesOnly)
          .eigenvalues();
  if (values[0] < -kRounding * values[2] || !(values[2] > 0.0)) {
    Remark("edges whose information matrix is not positive semidefinite, or zero, are left out");
    return false;
  }
  return true;
}

void G2oReader::ReadVertex(std::string_view words) {
  constexpr char kExpected[] =
      "expected a vertex as an integer id and three finite numbers x y theta";
  const std::int64_t id = TakeId(&words, kExpected);
  const std::vector<double> pose = Numbers(words, 3, kExpected);
  if (!position_.emplace(id, graph_.nodes.size()).second) {
    Fail("expected one vertex for each id, found a second one for " + std::to_string(id));
  }
  graph_.nodes.push_back({id, 0.0, {pose[0], pose[1], pose[2]}});
}

void G2oReader::ReadEdge(std::string_view words, const InformationOrder& order, int extra_fields) {
  const std::int64_t i = TakeId(&words, kEdgeFields), j = TakeId(&words, kEdgeFields);
  for (int k = 0; k < extra_fields; ++k) TakeWord(&words);
  const std::vector<double> numbers = Numbers(words, 9, kEdgeFields);
  Edge edge{i, j, {numbers[0], numbers[1], numbers[2]}};
  for (int k = 0; k < 6; ++k) {
    const auto [row, column] = order[k];
    edge.information(row, column) = edge.information(column, row) = numbers[3 + k];
  }
  mentions_.push_back({i, line_});
  mentions_.push_back({j, line_});
  if (i == j) {
    Remark("edges from a vertex to itself are left out");
  } else if (IsInformation(edge.information)) {
    graph_.edges.push_back(edge);
  }
}

void G2oReader::ReadPrior(std::string_view words) {
  const std::int64_t id = TakeId(&words, kPriorFields);
  const std::vector<double> numbers = Numbers(words, 9, kPriorFields);
  Prior prior{id, {numbers[0], numbers[1], numbers[2]}, {}};
  for (int k = 0; k < 6; ++k) {
    const auto [row, column] = kG2oOrder[k];
    prior.information(row, column) = prior.information(column, row) = numbers[3 + k];
  }
  mentions_.push_back({id, line_});
  if (!IsInformation(prior.information)) return;
  // g2o's error is expressed in the frame of the measured pose, that of an edge in the world's.
  Eigen::Matrix3d world_R_node = Eigen::Matrix3d::Identity();
  world_R_node.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(numbers[2]).toRotationMatrix();
  prior.information = world_R_node * prior.information * world_R_node.transpose();
  // Symmetric to the bit, as what is written has one half of it only.
  prior.information.triangularView<Eigen::StrictlyLower>() = prior.information.transpose();
  priors_.push_back(prior);
}

void G2oReader::ReadPositionPrior(std::string_view words) {
  const std::int64_t id = TakeId(&words, kPositionPriorFields);
  const std::vector<double> numbers = Numbers(words, 5, kPositionPriorFields);
  Prior prior{id, {numbers[0], numbers[1], 0.0}, Eigen::Matrix3d::Zero()};
  prior.information.topLeftCorner<2, 2>() << numbers[2], numbers[3], numbers[3], numbers[4];
  mentions_.push_back({id, line_});
  if (IsInformation(prior.information)) priors_.push_back(prior);
}

void G2oReader::ReadFix(std::string_view words) {
  do {
    const std::int64_t id = TakeId(&words, "expected FIX with integer ids");
    mentions_.push_back({id, line_});
    fixed_.push_back(id);
  } while (!WordsOf(words).empty());
}

void G2oReader::MakeNodes() {
  std::vector<std::int64_t> ids;
  for (const Mention& mention : mentions_) ids.push_back(mention.id);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const std::int64_t id : ids) {
    position_.emplace(id, graph_.nodes.size());
    graph_.nodes.push_back({id, 0.0, {}});
  }
}

// A fixed vertex with the largest id, at the origin: no robot ends where its frame begins and
// knows it. -1: there is none.
std::int64_t G2oReader::OriginOfPriors() const {
  if (graph_.nodes.empty()) return -1;
  const Node& last = *std::ranges::max_element(graph_.nodes, {}, &Node::id);
  const bool is_fixed = std::ranges::find(fixed_, last.id) != fixed_.end();
  return is_fixed && last.world_T_node == SE2{} ? last.id : -1;
}

// Neighbors in ascending order of the ids that exist are the robot's way: where nodes were
// removed, the edge across the gap is as sure as the others.
void G2oReader::TellChainFromClosures() {
  std::vector<std::int64_t> ids;
  for (const Node& node : graph_.nodes) ids.push_back(node.id);
  std::sort(ids.begin(), ids.end());
  const bool count_up = !ids.empty() && static_cast<std::uint64_t>(ids.back()) -
                                                static_cast<std::uint64_t>(ids.front()) ==
                                            ids.size() - 1;
  const auto rank = [&](std::int64_t id) {
    if (count_up) return static_cast<std::ptrdiff_t>(id - ids.front());
    return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
  };
  // The origin that AddPriors adds, in a file that was written.
  const std::int64_t origin = OriginOfPriors();
  for (Edge& edge : graph_.edges) {
    const bool neighbors =
        std::abs(rank(edge.i) - rank(edge.j)) == 1 && edge.i != origin && edge.j != origin;
    edge.kind = neighbors ? EdgeKind::kOdometry : EdgeKind::kLoopClosure;
  }
}

// A prior is a loop closure with a fixed node at the origin: it may be wrong as well.
void G2oReader::AddPriors() {
  std::int64_t id = 0;
  for (const Node& node : graph_.nodes) id = std::max(id, node.id);
  if (id == std::numeric_limits<std::int64_t>::max()) {
    Fail("expected ids below 2^63 - 1 in a file with priors");
  }
  ++id;
  for (const Prior& prior : priors_) {
    Remark("priors are taken for loop closures with a fixed vertex at the origin");
    graph_.edges.push_back(
        {id, prior.id, prior.world_T_node, prior.information, EdgeKind::kLoopClosure});
  }
  graph_.nodes.push_back({id, 0.0, {}, true});
}

void G2oReader::PlaceNodes() {
  std::vector<SE2> poses = PosesOf(graph_);
  InitializeFromOdometry(graph_, IndexGraph(graph_), &poses);
  for (std::size_t k = 0; k < poses.size(); ++k) graph_.nodes[k].world_T_node = poses[k];
}

}  // namespace gmapping_spa::backend
