// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/closure_mixture.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
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

// Of the area of the map, where wrong measurements may lie: of the nodes along the robot's way, and
// not of an origin that only priors name.
double LogArea(const PoseGraphView& graph, const GraphIndex& index, const std::vector<SE2>& poses) {
  Eigen::AlignedBox2d area;
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    if (graph.edges[k].kind == EdgeKind::kLoopClosure) continue;
    area.extend(poses[index.edges[k].i].translation());
    area.extend(poses[index.edges[k].j].translation());
  }
  if (area.isEmpty()) {
    for (const SE2& pose : poses) area.extend(pose.translation());
  }
  // A metre around it, so that a map of one pose has an area too.
  const Eigen::Array2d sides = area.sizes().array() + 2.0;
  return std::log(sides.prod());
}

// What a loop closure measures: all of the pose, or some directions of it.
struct Measured {
  double dimensions = 0.0;
  double log_volume = 0.0;  // that wrong measurements are spread over
  // For a variance factor of 1: log density of the error zero as an inlier, over that as an
  // outlier.
  double log_density_ratio = 0.0;
};

Measured MeasuredBy(const Edge& edge, double log_area) {
  constexpr double kRounding = 1e-12;
  const double log_turn = std::log(2.0 * std::numbers::pi);
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(edge.information, Eigen::EigenvaluesOnly)
          .eigenvalues();
  Measured measured;
  for (const double value : values) {
    if (value <= kRounding * values[2]) continue;
    measured.dimensions += 1.0;
    measured.log_volume += 0.5 * log_area;
    measured.log_density_ratio += 0.5 * (std::log(value) - log_turn);
  }
  // One direction is the heading, which may be any angle.
  if (edge.information(2, 2) > 0.0) measured.log_volume += log_turn - 0.5 * log_area;
  measured.log_density_ratio += measured.log_volume;
  return measured;
}

// The loop closures of a graph with their errors.
struct Closures {
  std::vector<std::size_t> edge;
  std::vector<Measured> measured;
  std::vector<double> squared_error;

  std::size_t size() const { return edge.size(); }
};

// The cost at which a loop closure is as likely an outlier as an inlier.
double OutlierCost(const Measured& measured, const ClosureMixture& mixture) {
  return measured.log_density_ratio -
         0.5 * measured.dimensions * std::log(mixture.variance_factor) +
         std::log(mixture.inlier_ratio / (1.0 - mixture.inlier_ratio));
}

// Expectation maximization from this variance factor on.
void Maximize(const Closures& closures, double variance_factor, ClosureMixture* mixture) {
  mixture->variance_factor = variance_factor;
  mixture->inlier_ratio = 0.5;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    double inliers = 0.0, dimensions = 0.0, sum = 0.0;
    for (std::size_t c = 0; c < closures.size(); ++c) {
      const double cost = 0.5 * closures.squared_error[c] / mixture->variance_factor;
      const double probability =
          1.0 / (1.0 + std::exp(cost - OutlierCost(closures.measured[c], *mixture)));
      mixture->inlier_probability[closures.edge[c]] = probability;
      inliers += probability;
      dimensions += probability * closures.measured[c].dimensions;
      if (probability > 0.0) sum += probability * closures.squared_error[c];
    }
    const double factor =
        std::max(1.0, (sum + 3.0 * kPriorInliers) / (dimensions + 3.0 * kPriorInliers));
    const double ratio =
        std::clamp(inliers / static_cast<double>(closures.size()), kLeastRatio, 1.0 - kLeastRatio);
    const bool finished =
        std::abs(factor - mixture->variance_factor) <= kTolerance * mixture->variance_factor &&
        std::abs(ratio - mixture->inlier_ratio) <= kTolerance * mixture->inlier_ratio;
    mixture->variance_factor = factor;
    mixture->inlier_ratio = ratio;
    if (finished) break;
  }
}

// Fills in what follows from the parameters.
void Complete(const Closures& closures, ClosureMixture* mixture) {
  for (std::size_t c = 0; c < closures.size(); ++c) {
    const Measured& measured = closures.measured[c];
    const double outlier_cost = OutlierCost(measured, *mixture);
    mixture->outlier_cost[closures.edge[c]] = std::max(0.0, outlier_cost);
    const double cost = 0.5 * closures.squared_error[c] / mixture->variance_factor;
    // -log(density), but for the density of outliers, which is the same for all explanations.
    const double outlier = -std::log(1.0 - mixture->inlier_ratio);
    const double inlier = cost - outlier_cost + outlier;
    const double smaller = std::min(inlier, outlier);
    mixture->negative_log_likelihood +=
        smaller - std::log(std::exp(smaller - inlier) + std::exp(smaller - outlier)) +
        measured.log_volume;
  }
}

// The variance factor that half of the loop closures would have as inliers.
double MedianFactor(const Closures& closures) {
  constexpr double kMedianOfChiSquare = 2.366;  // with three degrees of freedom
  std::vector<double> squared = closures.squared_error;
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return *middle / kMedianOfChiSquare;
}

}  // namespace

ClosureMixture FitClosureMixture(const PoseGraphView& graph, const GraphIndex& index,
                                 const std::vector<SE2>& poses) {
  const std::vector<double> squared = SquaredErrors(graph, index, poses);
  const double log_area = LogArea(graph, index, poses);
  ClosureMixture mixture;
  mixture.inlier_probability.assign(squared.size(), 1.0);
  mixture.outlier_cost.assign(squared.size(), std::numeric_limits<double>::infinity());
  Closures closures;
  for (std::size_t k = 0; k < squared.size(); ++k) {
    if (graph.edges[k].kind != EdgeKind::kLoopClosure) {
      mixture.negative_log_likelihood += 0.5 * squared[k];
      continue;
    }
    closures.edge.push_back(k);
    closures.measured.push_back(MeasuredBy(graph.edges[k], log_area));
    closures.squared_error.push_back(squared[k]);
  }
  if (closures.size() == 0) return mixture;
  // Edges may say by far too small a covariance: then nothing near a factor of 1 is an inlier.
  ClosureMixture other = mixture;
  Maximize(closures, 1.0, &mixture);
  Complete(closures, &mixture);
  const double median_factor = MedianFactor(closures);
  if (!(median_factor > mixture.variance_factor)) return mixture;
  Maximize(closures, median_factor, &other);
  Complete(closures, &other);
  return other.negative_log_likelihood < mixture.negative_log_likelihood ? other : mixture;
}

std::vector<Edge> AcceptedEdges(std::span<const Edge> edges,
                                const std::vector<double>& inlier_probability,
                                double variance_factor) {
  std::vector<Edge> accepted;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (inlier_probability[k] < 0.5) continue;
    accepted.push_back(edges[k]);
    if (edges[k].kind == EdgeKind::kLoopClosure) accepted.back().information /= variance_factor;
  }
  return accepted;
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
