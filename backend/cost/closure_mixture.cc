#include "backend/cost/closure_mixture.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "backend/cost/graph_cost.h"

namespace gmapping_spa::backend {
namespace {

constexpr int kMaxIterations = 50;
constexpr double kTolerance = 1e-6;  // relative, of the variance factor and the inlier ratio
// That many inliers without a surprise are believed in before any is seen: one wrong loop closure
// alone must not pass for a large variance.
constexpr double kPriorInliers = 10.0;
// Neither kind is ever ruled out.
constexpr double kLeastRatio = 1e-3;

// log of the volume that a wrong measurement may come from: the area of the map, any heading.
double LogOutlierVolume(const std::vector<SE2>& poses) {
  Eigen::AlignedBox2d area;
  for (const SE2& pose : poses) area.extend(pose.translation());
  // A metre around it, so that a map of one pose has an area too.
  const Eigen::Array2d sides = area.sizes().array() + 2.0;
  return std::log(sides.prod() * 2.0 * std::numbers::pi);
}

// Of one loop closure, for a variance factor of 1: log density of the error zero as an inlier, over
// that as an outlier.
double LogDensityRatio(const Edge& edge, double log_volume) {
  return log_volume - 1.5 * std::log(2.0 * std::numbers::pi) +
         0.5 * std::log(edge.information.determinant());
}

}  // namespace

ClosureMixture FitClosureMixture(const PoseGraphView& graph, const GraphIndex& index,
                                 const std::vector<SE2>& poses) {
  const std::vector<double> squared = SquaredErrors(graph, index, poses);
  const double log_volume = LogOutlierVolume(poses);
  ClosureMixture mixture;
  mixture.inlier_probability.assign(squared.size(), 1.0);
  mixture.outlier_cost.assign(squared.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> closures;
  std::vector<double> log_ratio;
  for (std::size_t k = 0; k < squared.size(); ++k) {
    if (graph.edges[k].kind != EdgeKind::kLoopClosure) {
      mixture.negative_log_likelihood += 0.5 * squared[k];
      continue;
    }
    closures.push_back(k);
    log_ratio.push_back(LogDensityRatio(graph.edges[k], log_volume));
  }
  if (closures.empty()) return mixture;

  mixture.inlier_ratio = 0.5;
  // The cost at which a loop closure is as likely an outlier as an inlier.
  const auto outlier_cost = [&](std::size_t c) {
    return log_ratio[c] - 1.5 * std::log(mixture.variance_factor) +
           std::log(mixture.inlier_ratio / (1.0 - mixture.inlier_ratio));
  };
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    double inliers = 0.0, sum = 0.0;
    for (std::size_t c = 0; c < closures.size(); ++c) {
      const double cost = 0.5 * squared[closures[c]] / mixture.variance_factor;
      const double probability = 1.0 / (1.0 + std::exp(cost - outlier_cost(c)));
      mixture.inlier_probability[closures[c]] = probability;
      inliers += probability;
      if (probability > 0.0) sum += probability * squared[closures[c]];
    }
    const double factor =
        std::max(1.0, (sum + 3.0 * kPriorInliers) / (3.0 * (inliers + kPriorInliers)));
    const double ratio =
        std::clamp(inliers / static_cast<double>(closures.size()), kLeastRatio, 1.0 - kLeastRatio);
    const bool finished =
        std::abs(factor - mixture.variance_factor) <= kTolerance * mixture.variance_factor &&
        std::abs(ratio - mixture.inlier_ratio) <= kTolerance * mixture.inlier_ratio;
    mixture.variance_factor = factor;
    mixture.inlier_ratio = ratio;
    if (finished) break;
  }
  for (std::size_t c = 0; c < closures.size(); ++c) {
    mixture.outlier_cost[closures[c]] = std::max(0.0, outlier_cost(c));
    const double cost = 0.5 * squared[closures[c]] / mixture.variance_factor;
    // -log(density), but for the density of outliers, which is the same for all explanations.
    const double outlier = -std::log(1.0 - mixture.inlier_ratio);
    const double inlier = cost - outlier_cost(c) + outlier;
    const double smaller = std::min(inlier, outlier);
    mixture.negative_log_likelihood +=
        smaller - std::log(std::exp(smaller - inlier) + std::exp(smaller - outlier)) + log_volume;
  }
  return mixture;
}

double MixtureCost(const PoseGraphView& graph, const GraphIndex& index,
                   const std::vector<SE2>& poses, const ClosureMixture& mixture) {
  const std::vector<double> squared = SquaredErrors(graph, index, poses);
  double cost = 0.0;
  for (std::size_t k = 0; k < squared.size(); ++k) {
    const bool closure = graph.edges[k].kind == EdgeKind::kLoopClosure;
    cost += std::min(0.5 * squared[k] / (closure ? mixture.variance_factor : 1.0),
                     mixture.outlier_cost[k]);
  }
  return cost;
}

}  // namespace gmapping_spa::backend
