// SPDX-License-Identifier: BSD-3-Clause
// The records of .g2o files and of what resembles them, one by one.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_G2O_READER_H_
#define GMAPPING_SPA_BACKEND_GRAPH_G2O_READER_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "backend/graph/g2o_io.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// Takes the lines of a file and makes a graph of them; ReadG2o tells which records there are.
class G2oReader {
 public:
  G2oReader(const std::string& name, const G2oOptions& options);

  void ReadLine(std::string_view line);
  // After the last line.
  PoseGraph Finish();

  const G2oRemarks& remarks() const { return remarks_; }

 private:
  // Row and column of each of the numbers of an information matrix.
  using InformationOrder = std::array<std::array<int, 2>, 6>;
  static constexpr InformationOrder kG2oOrder = {{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  static constexpr InformationOrder kToroOrder = {{{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}}};

  // A mention of a node, to be checked when all nodes are known.
  struct Mention {
    std::int64_t id;
    int line;
  };

  // What is known of the pose of a node in the world, as an edge from the origin.
  struct Prior {
    std::int64_t id;
    SE2 world_T_node;
    Eigen::Matrix3d information;
  };

  [[noreturn]] void Fail(const std::string& expectation) const;
  [[noreturn]] void FailAtRecord(std::string_view tag) const;
  // What is left out or taken for something else: an error when the options are strict.
  void Remark(const std::string& remark);

  void ReadVertex(std::string_view words);
  // `extra_fields` stand between the ids and the measurement, and are not used.
  void ReadEdge(std::string_view words, const InformationOrder& order, int extra_fields);
  void ReadPrior(std::string_view words);
  void ReadPositionPrior(std::string_view words);
  void ReadFix(std::string_view words);
  // Numbers of the rest of a line, all of it; fails with `expectation` on anything else.
  std::vector<double> Numbers(std::string_view words, std::size_t count,
                              const char* expectation) const;
  std::int64_t TakeId(std::string_view* words, const char* expectation) const;
  bool IsInformation(const Eigen::Matrix3d& information);

  void MakeNodes();
  std::int64_t OriginOfPriors() const;
  void TellChainFromClosures();
  void AddPriors();
  void PlaceNodes();

  const std::string& name_;
  G2oOptions options_;
  int line_ = 0;
  PoseGraph graph_;
  std::unordered_map<std::int64_t, std::size_t> position_;  // of a node, by id
  std::vector<Mention> mentions_;
  std::vector<std::int64_t> fixed_;
  std::vector<Prior> priors_;
  G2oRemarks remarks_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_G2O_READER_H_
