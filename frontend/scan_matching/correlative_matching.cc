// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/correlative_matching.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>
#include <vector>

#include "frontend/scan_matching/pose_lattice.h"
#include "frontend/scan_matching/score_peak.h"

namespace gmapping_spa::scan_matching {

using backend::SE2;

namespace {

// A scan of near points must not make the lattice coarse: the initial pose may be on its edge.
constexpr double kMaxAngularStep = 0.05;

// A point farther away than this, which makes for tiny angular steps, is no laser's.
constexpr double kMaxPointCells = 10000.0;

int StepsToCover(double half_width, double step) {
  CHECK_GE(half_width, 0.0);
  const double steps = std::ceil(half_width / step - 1e-9);
  CHECK_LT(steps, map::kMaxCellIndex);
  return static_cast<int>(steps);
}

// The order of best-first search: whether `a` comes after `b`. Where bounds are equal, blocks come
// before poses, so that the poses of the largest sum are all known before the first is taken; and
// that is the one nearest to the middle.
struct ComesAfter {
  static auto TieBreak(const PoseBlock& block) {
    const double angle = block.angle, x = block.x, y = block.y;
    return std::tuple(-block.level, angle * angle + x * x + y * y, angle, y, x);
  }
  bool operator()(const PoseBlock& a, const PoseBlock& b) const {
    if (a.bound != b.bound) return a.bound < b.bound;
    return TieBreak(a) > TieBreak(b);
  }
};

}  // namespace

CorrelativeMatcher::CorrelativeMatcher(const Options& options,
                                       const std::vector<Eigen::Vector2d>& reference)
    : options_(options),
      pyramid_(MakeLikelihoodField(options.field, reference), options.pyramid_levels) {
  CHECK_GT(options.min_score, 0.0);
  CHECK_GT(options.runner_up_floor, 0.0);
  CHECK_LE(options.runner_up_floor, 1.0);
  CHECK_GE(options.peak_separation_m, 0.0);
  CHECK_GE(options.peak_separation_rad, 0.0);
  CHECK_GT(options.independent_points, 0.0);
}

double CorrelativeMatcher::AngularStep(const std::vector<Eigen::Vector2d>& points) const {
  double farthest_m = 0.0;
  for (const Eigen::Vector2d& point : points) {
    CHECK_LT(point.norm(), kMaxPointCells * options_.field.resolution_m);
    farthest_m = std::max(farthest_m, point.norm());
  }
  return std::min(options_.field.resolution_m / farthest_m, kMaxAngularStep);
}

// The middle of the window and its steps.
PoseLattice CorrelativeMatcher::LatticeOf(const std::vector<Eigen::Vector2d>& points,
                                          const SE2& initial_map_T_scan,
                                          const SearchWindow& window) const {
  CHECK_LE(window.angular_rad, std::numbers::pi);
  const double resolution_m = options_.field.resolution_m, angular_step = AngularStep(points);
  return PoseLattice(
      {initial_map_T_scan, resolution_m, angular_step, StepsToCover(window.linear_m, resolution_m),
       StepsToCover(window.angular_rad, angular_step)},
      &pyramid_, points);
}

// Blocks come in order of their bounds: the first pose is the best one, the first pose outside of
// its peak the second, and so on.
std::vector<PoseBlock> CorrelativeMatcher::BestBlocks(const PoseLattice& lattice, double full_sum,
                                                      int count) const {
  std::priority_queue<PoseBlock, std::vector<PoseBlock>, ComesAfter> queue;
  // A sum below this is neither that of a match nor of a further peak that matters.
  double floor = options_.runner_up_floor * options_.min_score * full_sum;
  const auto push_parts = [&](const PoseBlock& block) {
    lattice.ForEachPart(block, [&](const PoseBlock& part) {
      if (part.bound >= floor) queue.push(part);
    });
  };
  for (const PoseBlock& root : lattice.Roots()) push_parts(root);

  std::vector<PoseBlock> best;
  std::vector<ScorePeak> peaks;
  while (!queue.empty() && static_cast<int>(best.size()) < count) {
    const PoseBlock block = queue.top();
    queue.pop();
    if (block.bound < (best.empty() ? options_.min_score * full_sum : floor)) break;
    if (std::any_of(peaks.begin(), peaks.end(),
                    [&](const ScorePeak& peak) { return peak.HoldsAllOf(block); })) {
      continue;
    }
    if (block.level > 0) {
      push_parts(block);
      continue;
    }
    if (best.empty()) floor = options_.runner_up_floor * block.bound;
    best.push_back(block);
    peaks.emplace_back(&lattice, block, options_.peak_separation_m, options_.peak_separation_rad);
  }
  return best;
}

CorrelativeMatch CorrelativeMatcher::Match(const std::vector<Eigen::Vector2d>& points,
                                           const SE2& initial_map_T_scan,
                                           const SearchWindow& window) const {
  CorrelativeMatch match;
  match.map_T_scan = initial_map_T_scan;
  if (points.empty()) return match;
  const PoseLattice lattice = LatticeOf(points, initial_map_T_scan, window);
  const double full_sum = 255.0 * static_cast<double>(points.size());
  const std::vector<PoseBlock> best = BestBlocks(lattice, full_sum, 2);
  if (best.empty()) return match;
  match.found = true;
  match.map_T_scan = lattice.Pose(best.front());
  match.score = best.front().bound / full_sum;
  match.runner_up_map_T_scan = lattice.Pose(best.back());
  match.runner_up_score =
      best.size() > 1 ? best.back().bound / full_sum : options_.runner_up_floor * match.score;
  if (options_.with_covariance) {
    const ScorePeak peak(&lattice, best.front(), options_.peak_separation_m,
                         options_.peak_separation_rad);
    match.covariance = peak.Covariance(options_.independent_points / full_sum);
  }
  return match;
}

std::vector<ScoredPose> CorrelativeMatcher::Peaks(const std::vector<Eigen::Vector2d>& points,
                                                  const SE2& initial_map_T_scan,
                                                  const SearchWindow& window, int count) const {
  std::vector<ScoredPose> peaks;
  if (points.empty()) return peaks;
  const PoseLattice lattice = LatticeOf(points, initial_map_T_scan, window);
  const double full_sum = 255.0 * static_cast<double>(points.size());
  for (const PoseBlock& block : BestBlocks(lattice, full_sum, count)) {
    peaks.push_back({lattice.Pose(block), block.bound / full_sum});
  }
  return peaks;
}

}  // namespace gmapping_spa::scan_matching
