// SPDX-License-Identifier: BSD-3-Clause
// Covariances of an optimized graph as a CSV file.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_COVARIANCE_TABLE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_COVARIANCE_TABLE_H_

#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "backend/plugin/optimizer.h"
#include "experiments/apps/covariance_choice.h"

namespace gmapping_spa::apps {

struct CovarianceTable {
  // Of nodes: i is the held node that the pose j is relative to, the first one of its component,
  // the covariance is that in the world frame. Of pairs: that of i_T_j in frame i.
  struct Row {
    std::int64_t i = 0;
    std::int64_t j = 0;
    backend::SE2 pose;  // world_T_j or i_T_j
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    // Of pairs: between the poses of i, rows, and j, columns, in the world frame.
    Eigen::Matrix3d cross_covariance = Eigen::Matrix3d::Zero();
  };

  bool of_pairs = false;
  std::vector<Row> rows;
  std::string loss;
  double variance_factor = 1.0;  // of loop closures, see backend::ClosureMixture
  std::size_t edges = 0;         // of the graph
  std::size_t edges_used = 0;    // those with a weight
  std::size_t components = 0;    // that these edges make of the graph
  bool by_back_end = false;
  double cpu_s = 0.0;
};

// Covariances of the poses of `graph`, which Optimize under `loss` came to with that summary.
// Throws std::runtime_error with one line when they do not exist, when there is no such node, or
// when nothing is known of the relative pose of a pair.
CovarianceTable MakeCovarianceTable(const backend::PoseGraph& graph, const CovarianceChoice& choice,
                                    const backend::Loss& loss, const backend::Summary& summary,
                                    backend::Optimizer* optimizer);

// A line of comment, a line of names, a line for each row; numbers read back as they are.
void WriteCovariances(const CovarianceTable& table, std::ostream& out);

// All but the rows.
nlohmann::ordered_json ToJson(const CovarianceTable& table);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_COVARIANCE_TABLE_H_
