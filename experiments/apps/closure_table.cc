// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/closure_table.h"

#include <iomanip>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "backend/text.h"

namespace gmapping_spa::apps {
namespace {

using loop_closure::ClosureRecord;

constexpr const char* kHeader =
    "old_node,node,old_stamp_s,stamp_s,path_length_m,distance_m,score,runner_up_score,overlap,"
    "inlier_ratio,mutual_inlier_ratio,mahalanobis_sq,x_m,y_m,theta_rad,source,verdict";

// The fields of a line, in their order; each throws with one line when it is not as expected.
class Fields {
 public:
  Fields(std::string place, std::string_view line) : place_(std::move(place)), rest_(line) {}

  double Number() {
    const std::string_view word = Word();
    const std::optional<double> number = backend::ParseNumber<double>(word);
    if (!number) Fail("a number", word);
    return *number;
  }

  int Node(std::size_t nodes) {
    const std::string_view word = Word();
    const std::optional<int> node = backend::ParseNumber<int>(word);
    if (!node || *node < 0 || static_cast<std::size_t>(*node) >= nodes) Fail("a node", word);
    return *node;
  }

  template <typename Enum>
  Enum Name(Enum last, const char* (*name_of)(Enum)) {
    const std::string_view word = Word();
    for (int value = 0; value <= static_cast<int>(last); ++value) {
      if (word == name_of(static_cast<Enum>(value))) return static_cast<Enum>(value);
    }
    Fail("a source and a verdict", word);
  }

 private:
  std::string_view Word() {
    const std::size_t end = rest_.find(',');
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return word;
  }
  [[noreturn]] void Fail(const char* expected, std::string_view found) const {
    throw std::runtime_error(place_ + ": expected " + expected + ", found " +
                             backend::Quoted(found));
  }

  std::string place_;
  std::string_view rest_;
};

}  // namespace

std::vector<ClosureRecord> ReadClosures(std::istream& in, const std::string& name,
                                        std::size_t nodes) {
  std::string line;
  if (!std::getline(in, line) || line != kHeader) {
    throw std::runtime_error(name + ":1: expected the header of loop closures, found " +
                             backend::Quoted(line));
  }
  std::vector<ClosureRecord> records;
  for (int number = 2; std::getline(in, line); ++number) {
    Fields fields(name + ":" + std::to_string(number), line);
    ClosureRecord record;
    record.old_node = fields.Node(nodes);
    record.node = fields.Node(nodes);
    fields.Number();  // stamps, which are those of the nodes
    fields.Number();
    for (double* value : {&record.path_length_m, &record.distance_m, &record.score,
                          &record.runner_up_score, &record.overlap, &record.inlier_ratio,
                          &record.mutual_inlier_ratio, &record.mahalanobis_sq, &record.old_T_node.x,
                          &record.old_T_node.y, &record.old_T_node.theta}) {
      *value = fields.Number();
    }
    record.source = fields.Name(loop_closure::Source::kFollowed, loop_closure::SourceName);
    record.verdict = fields.Name(loop_closure::Verdict::kAccepted, loop_closure::VerdictName);
    records.push_back(record);
  }
  return records;
}

void WriteClosures(const std::vector<loop_closure::ClosureRecord>& records,
                   const std::vector<backend::Node>& nodes, std::ostream& out) {
  out << kHeader << '\n';
  for (const loop_closure::ClosureRecord& record : records) {
    const backend::SE2& pose = record.old_T_node;
    out << std::fixed << record.old_node << ',' << record.node << ',' << std::setprecision(6)
        << nodes.at(record.old_node).stamp_s << ',' << nodes.at(record.node).stamp_s << ','
        << std::setprecision(3) << record.path_length_m << ',' << record.distance_m << ','
        << record.score << ',' << record.runner_up_score << ',' << record.overlap << ','
        << record.inlier_ratio << ',' << record.mutual_inlier_ratio << ',' << record.mahalanobis_sq
        << ',' << std::setprecision(4) << pose.x << ',' << pose.y << ',' << pose.theta << ','
        << loop_closure::SourceName(record.source) << ','
        << loop_closure::VerdictName(record.verdict) << '\n';
  }
}

Json CountClosures(const std::vector<loop_closure::ClosureRecord>& records) {
  Json counts = {{"candidates", records.size()}, {"accepted", 0}};
  Json& rejected = counts["rejected"] = Json::object();
  for (const loop_closure::ClosureRecord& record : records) {
    if (record.verdict == loop_closure::Verdict::kAccepted) {
      counts["accepted"] = counts["accepted"].get<int>() + 1;
    } else {
      const char* reason = loop_closure::VerdictName(record.verdict);
      rejected[reason] = rejected.value(reason, 0) + 1;
    }
  }
  return counts;
}

}  // namespace gmapping_spa::apps
