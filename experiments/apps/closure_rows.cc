// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/closure_rows.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "backend/text.h"

namespace gmapping_spa::apps {
namespace {

using loop_closure::Verdict;

constexpr std::array kPose = {"x_m", "y_m", "theta_rad"};
constexpr std::array kInformation = {"I11", "I12", "I13", "I22", "I23", "I33"};

std::vector<std::string_view> CellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma; (comma = line.find(',')) != line.npos; line.remove_prefix(comma + 1)) {
    cells.push_back(line.substr(0, comma));
  }
  cells.push_back(line);
  for (std::string_view& cell : cells) {  // without blanks, and the end of a line of Windows
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\r')) cell.remove_suffix(1);
    while (cell.starts_with(' ')) cell.remove_prefix(1);
  }
  return cells;
}

class Reader {
 public:
  Reader(std::istream& in, const std::string& name, int nodes)
      : in_(in), name_(name), nodes_(nodes) {}

  std::vector<ClosureRow> Read() {
    ReadHeader();
    std::vector<ClosureRow> rows;
    while (Next()) {
      rows.push_back(ReadRow());
      CheckThatNodesAreNew(rows.back());
    }
    return rows;
  }

 private:
  [[noreturn]] void Fail(const std::string& expected, const std::string& found) const {
    throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": expected " + expected +
                             ", found " + found);
  }

  // Moves to the next line that is not blank.
  bool Next() {
    while (std::getline(in_, text_)) {
      ++line_;
      cells_ = CellsOf(line_ == 1 ? backend::WithoutByteOrderMark(text_) : text_);
      if (std::ranges::any_of(cells_, [](std::string_view cell) { return !cell.empty(); })) {
        return true;
      }
    }
    if (in_.bad()) throw std::runtime_error(name_ + ": cannot be read");
    return false;
  }

  void ReadHeader() {
    constexpr char kExpected[] =
        "a first line that names the columns, separated by commas: old_node, node, verdict, ...";
    if (!Next()) throw std::runtime_error(name_ + ": expected " + kExpected + ", found nothing");
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (!columns_.emplace(cells_[k], k).second) {
        Fail("a name for one column", backend::Quoted(cells_[k]) + " twice");
      }
    }
    for (const char* required : {"old_node", "node", "verdict"}) {
      if (!columns_.contains(required)) Fail(kExpected, std::string("no ") + required);
    }
    has_found_ = columns_.contains("found");
  }

  std::string_view Cell(const std::string& column) const {
    const auto found = columns_.find(column);
    return found == columns_.end() || found->second >= cells_.size() ? "" : cells_[found->second];
  }

  int Node(const std::string& column) const {
    const auto node = backend::ParseFinite<int>(Cell(column));
    if (!node || *node < 0 || *node >= nodes_) {
      Fail("a node from 0 to " + std::to_string(nodes_ - 1) + " as " + column,
           backend::Quoted(Cell(column)));
    }
    return *node;
  }

  // All of the columns, or nothing where all of them are empty.
  template <std::size_t kCount>
  std::optional<std::array<double, kCount>> Numbers(
      const std::array<const char*, kCount>& columns) const {
    if (std::ranges::all_of(columns, [&](const char* c) { return Cell(c).empty(); })) return {};
    std::array<double, kCount> numbers{};
    for (std::size_t k = 0; k < kCount; ++k) {
      const auto number = backend::ParseFinite<double>(Cell(columns[k]));
      if (!number) {
        Fail(std::string("a finite number as ") + columns[k], backend::Quoted(Cell(columns[k])));
      }
      numbers[k] = *number;
    }
    return numbers;
  }

  ClosureRow ReadRow() const {
    if (cells_.size() > columns_.size()) {
      Fail(std::to_string(columns_.size()) + " columns", std::to_string(cells_.size()));
    }
    ClosureRow row;
    row.line = line_;
    loop_closure::ClosureRecord& record = row.record;
    record.old_node = Node("old_node");
    record.node = Node("node");
    if (record.old_node >= record.node) {
      Fail("the older node, with the smaller number, as old_node",
           std::to_string(record.old_node) + " and " + std::to_string(record.node));
    }
    ReadVerdict(&row);
    if (const auto pose = Numbers(kPose)) {
      record.old_T_node = {(*pose)[0], (*pose)[1], backend::WrapAngle((*pose)[2])};
      row.has_pose = true;
    }
    if (const auto entries = Numbers(kInformation)) ReadInformation(*entries, &row);
    if (record.verdict == Verdict::kAccepted && !row.has_pose &&
        row.change != ClosureRow::Change::kAdded) {
      Fail("the pose of an accepted closure as x_m, y_m, theta_rad", "none");
    }
    return row;
  }

  void ReadVerdict(ClosureRow* row) const {
    using Change = ClosureRow::Change;
    loop_closure::ClosureRecord& record = row->record;
    const std::string_view word = Cell("verdict"), found_word = Cell("found");
    const auto found = loop_closure::VerdictNamed(found_word);
    const auto verdict = word == "accept" || word == "add" ? Verdict::kAccepted
                         : word == "reject"                ? Verdict::kRejected
                                                           : loop_closure::VerdictNamed(word);
    if (!verdict || (verdict != found && verdict != Verdict::kAccepted &&
                     verdict != Verdict::kRejected && found)) {
      Fail("accepted, rejected, add, or what was found, as verdict", backend::Quoted(word));
    }
    if (!found && !found_word.empty()) {
      Fail("what the program found as found", backend::Quoted(found_word));
    }
    record.verdict = *verdict;
    record.source = loop_closure::SourceNamed(Cell("source")).value_or(loop_closure::Source::kHand);
    const bool is_new = word == "add" || (has_found_ && !found);
    if (is_new) {
      record.source = loop_closure::Source::kHand;
      record.is_by_hand = true;
      row->change = verdict == Verdict::kAccepted ? Change::kAdded : Change::kRejected;
    } else if (has_found_ && verdict != found) {
      record.overruled_verdict = *found;
      record.is_by_hand = true;
      row->change = verdict == Verdict::kAccepted ? Change::kAccepted : Change::kRejected;
    }
  }

  void ReadInformation(const std::array<double, kInformation.size()>& entries,
                       ClosureRow* row) const {
    Eigen::Matrix3d& information = row->record.information;
    auto entry = entries.begin();
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) information(i, j) = information(j, i) = *entry++;
    }
    row->has_information = true;
    const Eigen::LLT<Eigen::Matrix3d> factors(information);
    if (row->record.verdict == Verdict::kAccepted && factors.info() != Eigen::Success) {
      Fail("a positive definite information matrix as I11 ... I33", "one that is none");
    }
  }

  void CheckThatNodesAreNew(const ClosureRow& row) {
    const loop_closure::ClosureRecord& record = row.record;
    if (record.verdict != Verdict::kAccepted) return;
    const auto [first, is_new] = lines_.emplace(std::pair(record.old_node, record.node), line_);
    if (!is_new) {
      Fail("one accepted closure of nodes " + std::to_string(record.old_node) + " and " +
               std::to_string(record.node),
           "that of line " + std::to_string(first->second) + " as well");
    }
  }

  std::istream& in_;
  const std::string& name_;
  int nodes_;
  int line_ = 0;
  std::string text_;
  std::vector<std::string_view> cells_;  // of text_
  std::map<std::string, std::size_t, std::less<>> columns_;
  bool has_found_ = false;
  std::map<std::pair<int, int>, int> lines_;  // of accepted rows, by their nodes
};

}  // namespace

std::vector<ClosureRow> ReadClosureRows(std::istream& in, const std::string& name, int nodes) {
  return Reader(in, name, nodes).Read();
}

}  // namespace gmapping_spa::apps
