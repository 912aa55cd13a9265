// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/optimization_record.h"

#include <algorithm>

#include "backend/scheduling/optimize.h"
#include "experiments/apps/backend_flags.h"

namespace gmapping_spa::apps {

using Json = nlohmann::ordered_json;

Json OptimizationRecord(const std::string& input, const backend::PoseGraph& graph,
                        const backend::G2oRemarks& remarks, const backend::Summary& summary,
                        double cpu_s) {
  Json iterations = Json::array();
  for (const backend::IterationRecord& record : summary.iterations) {
    iterations.push_back({{"cost", record.cost},
                          {"step_norm", record.step_norm},
                          {"damping", record.damping},
                          {"linear_solver_s", record.linear_solver_s},
                          {"total_s", record.total_s}});
  }
  Json rejected = Json::array();
  const auto closures = std::ranges::count(graph.edges, backend::EdgeKind::kLoopClosure,
                                           [](const backend::Edge& edge) { return edge.kind; });
  for (const std::size_t k : backend::RejectedClosures(graph.edges, summary)) {
    rejected.push_back(
        {{"i", graph.edges[k].i}, {"j", graph.edges[k].j}, {"weight", summary.edge_weights[k]}});
  }
  const backend::Options options = OptionsFromFlags();
  return {{"input", input},
          {"nodes", graph.nodes.size()},
          {"edges", graph.edges.size()},
          {"input_remarks", remarks},
          {"backend", BackendFromFlags()},
          {"init", backend::InitializationName(options.initialization)},
          {"loss", backend::LossKindName(options.loss.kind)},
          {"loss_scale", options.loss.scale},
          {"settings", options.settings},
          {"termination", backend::TerminationName(summary.termination)},
          {"message", summary.message},
          {"initial_cost", summary.initial_cost},
          {"final_cost", summary.final_cost},
          {"loop_closures",
           {{"count", closures},
            {"rejected", rejected.size()},
            {"variance_factor", summary.variance_factor},
            {"rejected_edges", rejected}}},
          {"cpu_s", cpu_s},
          {"iterations", iterations},
          {"convention",
           "cost: 1/2 sum rho(e' Omega e), e = (R_i' (t_j - t_i) - t_ij, wrap(theta_j - theta_i - "
           "theta_ij)), recomputed apart from the back end; the loss rho is for loop closures, "
           "edges between ids that are not neighbors in ascending order"}};
}

}  // namespace gmapping_spa::apps
