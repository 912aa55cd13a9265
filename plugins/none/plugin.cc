// SPDX-License-Identifier: BSD-3-Clause
// The back end that changes nothing: what the front end does without one.
#include "backend/plugin/plugin.h"
#include "backend/cost/graph_cost.h"

namespace gmapping_spa::none {
namespace {

class NoOptimizer : public backend::StatelessOptimizer {
 public:
  static constexpr backend::LossKind kLosses[] = {
      // it costs poses, and changes none
      backend::LossKind::kHuber, backend::LossKind::kCauchy, backend::LossKind::kDcs,
      backend::LossKind::kTruncated};

  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge> edges,
                            std::span<backend::Node> nodes) override {
    backend::Summary summary;
    summary.termination = backend::Termination::kConverged;
    summary.message = "left the poses as they were";
    summary.initial_cost = summary.final_cost = backend::GraphCost({nodes, edges}, options.loss);
    return summary;
  }
};

}  // namespace
}  // namespace gmapping_spa::none

GMAPPING_SPA_BACKEND_PLUGIN(gmapping_spa::none::NoOptimizer, "none",
                            "leaves all poses as they are");
GMAPPING_SPA_BACKEND_STATE(gmapping_spa::none::NoOptimizer);
