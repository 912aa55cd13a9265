// SPDX-License-Identifier: BSD-3-Clause
// A pose graph as a problem of Ceres.
#ifndef GMAPPING_SPA_PLUGINS_CERES_POSE_PROBLEM_H_
#define GMAPPING_SPA_PLUGINS_CERES_POSE_PROBLEM_H_

#include <ceres/problem.h>

#include <memory>
#include <vector>

#include "backend/cost/robust_loss.h"
#include "backend/graph/graph_index.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::ceres_backend {

// Each pose is a parameter block of three doubles in a row, those of held nodes are constant.
// Angles are plain numbers: errors are wrapped, poses are left as they come out.
class PoseProblem {
 public:
  // `graph` and `index` outlive the object; `loss` is for loop closures.
  PoseProblem(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
              const backend::Loss& loss);
  ~PoseProblem();
  PoseProblem(const PoseProblem&) = delete;
  PoseProblem& operator=(const PoseProblem&) = delete;

  ::ceres::Problem* problem() { return &problem_; }
  const double* block(int node) const { return &poses_[node].x; }
  const std::vector<backend::SE2>& poses() const { return poses_; }

 private:
  class RobustLoss;

  std::vector<backend::SE2> poses_;
  std::unique_ptr<RobustLoss> loss_;
  ::ceres::Problem problem_;
};

}  // namespace gmapping_spa::ceres_backend

#endif  // GMAPPING_SPA_PLUGINS_CERES_POSE_PROBLEM_H_
