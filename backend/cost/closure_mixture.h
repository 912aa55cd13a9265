// SPDX-License-Identifier: BSD-3-Clause
// How likely each loop closure of a graph is right.
#ifndef GMAPPING_SPA_BACKEND_COST_CLOSURE_MIXTURE_H_
#define GMAPPING_SPA_BACKEND_COST_CLOSURE_MIXTURE_H_

#include <span>
#include <vector>

#include "backend/graph/graph_index.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// The errors of loop closures as a mixture of inliers, whose errors are normal with
// `variance_factor` times the covariance that the edges say, and outliers, whose measurements may
// be any pose in the area of the map: the null hypothesis of Olson and Agarwal 2013, "Inference on
// Networks of Mixtures for Robust Robot Mapping". Vectors have one entry for each edge of the
// graph.
struct ClosureMixture {
  double variance_factor =
      1.0;                    // from 1: edges may say too small a covariance, never too large a one
  double inlier_ratio = 1.0;  // part of the loop closures
  std::vector<double> inlier_probability;  // 1 for edges that are no loop closures
  std::vector<double> outlier_cost;  // the cost of an edge at which its inlier probability is 1/2
  double negative_log_likelihood = 0.0;  // of all edges; smaller is the better explanation
};

// The mixture that explains the errors at `poses` best: expectation maximization that starts from
// the covariances as the edges say them. Few loop closures change the variance little.
ClosureMixture FitClosureMixture(const PoseGraphView& graph, const GraphIndex& index,
                                 const std::vector<SE2>& poses);

// The edges without loop closures that are rather wrong than right, those closures that are left
// with the variance that they show.
std::vector<Edge> AcceptedEdges(std::span<const Edge> edges,
                                const std::vector<double>& inlier_probability,
                                double variance_factor);

// Cost of other poses under a mixture: 1/2 sum e' Omega e, where the covariance of loop closures
// has the variance factor, and none costs more than its outlier_cost.
double MixtureCost(const PoseGraphView& graph, const GraphIndex& index,
                   const std::vector<SE2>& poses, const ClosureMixture& mixture);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_COST_CLOSURE_MIXTURE_H_
