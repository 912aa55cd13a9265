// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/verification.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "frontend/loop_closure/explanation.h"
#include "frontend/scan_matching/joined_points.h"

namespace gmapping_spa::loop_closure {

using backend::SE2;

namespace {

// Who drifted by more than this does not fit the old map any more where the estimate says: there 10
// to 80 % of what true closures explain is explained on recorded logs, and more than 95 % where a
// building repeats itself and nothing has drifted.
constexpr double kElsewhere_m = 0.5;
constexpr double kFitsAsWell = 0.9;
constexpr double kLeastKnownPart = 0.1;

// UsualInlierRatio from which on a node is asked for all of the ratio that is needed; where it is
// less, for less in proportion, down to the other. Among people, or with few beams, no more fits.
constexpr double kWellMapped = 0.86;
constexpr double kLeastUsual = 0.6;

// Within which a pose that was predicted and not found is taken to be right.
constexpr double kPredicted_m = 0.3;

// Within so small a window two nodes overlap by what the estimate says, more or less.
constexpr double kSmallWindow_m = 2.5;

// Around a match at the border of a window: the peak that it belongs to lies beyond.
constexpr scan_matching::SearchWindow kBeyondBorder{1.5, 0.15};

// So near to its border that the best pose may be just the highest one on the slope of a peak
// outside.
bool IsAtBorder(const scan_matching::SearchWindow& window, const SE2& center, const SE2& found) {
  constexpr double kBorder_m = 0.1;
  constexpr double kBorder_rad = 0.01;
  const Eigen::Vector2d shift = found.translation() - center.translation();
  const double turn_rad = Between(center, found).theta;
  return shift.cwiseAbs().maxCoeff() > window.linear_m - kBorder_m ||
         std::abs(turn_rad) > window.angular_rad - kBorder_rad;
}

}  // namespace

Verifier::Verifier(const Options& options, const DriftModel& drift,
                   const CandidateOptions& candidates)
    : options_(options),
      drift_(drift),
      candidates_(candidates),
      gauss_newton_(options.gauss_newton),
      rivals_(RivalOptions()) {}

scan_matching::SearchWindow Verifier::WindowOf(double path_length_m) const {
  const double sigmas = candidates_.sigmas;
  return {std::min(sigmas * drift_.LinearSigma(path_length_m), candidates_.max_drift_m),
          std::min(sigmas * drift_.AngularSigma(path_length_m), options_.max_turn_rad)};
}

RivalSearch::Options Verifier::RivalOptions() const {
  return {.old_reach_m = options_.old_reach_m,
          .new_reach_m = options_.new_reach_m,
          .cell_m = options_.cell_m,
          .min_way_m = candidates_.min_path_length_m,
          .elsewhere_m = kElsewhere_m,
          .max_reach_m = candidates_.max_drift_m,
          .max_runner_up_score = options_.max_runner_up_score,
          .search = options_.search};
}

// A small window needs no high pyramid. The covariance is that of fine alignment, later.
scan_matching::CorrelativeMatcher::Options Verifier::SearchOptions(
    const scan_matching::SearchWindow& window) const {
  scan_matching::CorrelativeMatcher::Options options = options_.search;
  const double cells = 2.0 * window.linear_m / options.field.resolution_m;
  const int levels = static_cast<int>(std::ceil(std::log2(std::max(cells, 2.0))));
  options.pyramid_levels = std::min(levels, options.pyramid_levels);
  options.runner_up_floor = 0.9 * options_.max_runner_up_score;
  options.with_covariance = false;
  return options;
}

ClosureRecord Verifier::Verify(const std::vector<SE2>& world_T_nodes,
                               const ScanOfNode& scan_of_node, int node,
                               const Candidate& candidate) const {
  const Expectation expectation{Between(world_T_nodes[candidate.old_node], world_T_nodes[node]),
                                WindowOf(candidate.path_length_m)};
  ClosureRecord record = Compare(world_T_nodes, scan_of_node, node, candidate, expectation);
  if (record.verdict != Verdict::kUnconfirmed) return record;
  if (record.mahalanobis_sq > options_.max_mahalanobis_sq) {
    record.verdict = Verdict::kMahalanobis;
  } else if (MayBeChance(world_T_nodes, scan_of_node, expectation.old_T_node, record)) {
    record.verdict = Verdict::kAmbiguous;
  } else if (expectation.window.linear_m > kSmallWindow_m) {
    AskOldScans(world_T_nodes, scan_of_node, expectation, &record);
  }
  LookForRivals(world_T_nodes, scan_of_node, &record);
  return record;
}

bool Verifier::MayBeChance(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                           const SE2& estimated_old_T_node, const ClosureRecord& record) const {
  const auto moves = [](const SE2& from, const SE2& to) {
    return Between(from, to).translation().norm();
  };
  if (moves(estimated_old_T_node, record.old_T_node) < kElsewhere_m) return false;
  const NodeRange old_nodes = NodesAround(world_T_nodes, record.old_node, options_.old_reach_m);
  const NodeRange new_nodes = NodesAround(world_T_nodes, record.node, options_.new_reach_m);
  const scan_matching::ScanPoints points =
      JoinScans(world_T_nodes, scan_of_node, new_nodes, record.node, options_.cell_m);
  if (static_cast<double>(points.size()) * options_.cell_m < options_.min_outline_m) return true;
  const map::OccupancyGrid map =
      BuildLocalMap(world_T_nodes, scan_of_node, old_nodes, record.old_node, options_.grid);
  const SE2 near =
      gauss_newton_
          .Align(map, points, estimated_old_T_node, scan_matching::GaussNewton::WeakPrior())
          .world_T_robot;
  if (moves(near, record.old_T_node) < kElsewhere_m) return false;
  const auto explain = [&](const SE2& old_T_node) {
    return Explain(map, points, old_T_node, options_.grid.occupied_threshold, 1);
  };
  const Explanation found = explain(record.old_T_node), estimate = explain(near);
  return estimate.known >= kLeastKnownPart * static_cast<double>(points.size()) &&
         estimate.part() >= kFitsAsWell * found.part();
}

ClosureRecord Verifier::VerifyAt(const std::vector<SE2>& world_T_nodes,
                                 const ScanOfNode& scan_of_node, int node,
                                 const Candidate& candidate, const Expectation& expectation) const {
  ClosureRecord record = Compare(world_T_nodes, scan_of_node, node, candidate, expectation);
  if (record.verdict != Verdict::kUnconfirmed && record.verdict != Verdict::kOverlap) return record;
  AskOldScans(world_T_nodes, scan_of_node, expectation, &record);
  LookForRivals(world_T_nodes, scan_of_node, &record);
  return record;
}

void Verifier::LookForRivals(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                             ClosureRecord* record) const {
  if (record->verdict == Verdict::kUnconfirmed &&
      rivals_.HasRival(world_T_nodes, scan_of_node, *record)) {
    record->verdict = Verdict::kRival;
  }
}

void Verifier::AskOldScans(const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node,
                           const Expectation& expectation, ClosureRecord* record) const {
  const bool is_found = record->verdict == Verdict::kUnconfirmed;
  const NodeRange old_nodes = NodesAround(world_T_nodes, record->old_node, options_.old_reach_m);
  const NodeRange new_nodes = NodesAround(world_T_nodes, record->node, options_.new_reach_m);
  const scan_matching::ScanPoints points =
      JoinScans(world_T_nodes, scan_of_node, old_nodes, record->old_node, options_.cell_m);
  const Explanation explanation = Explain(
      BuildLocalMap(world_T_nodes, scan_of_node, new_nodes, record->node, options_.grid), points,
      Inverse(is_found ? record->old_T_node : expectation.old_T_node),
      options_.grid.occupied_threshold,
      is_found ? 1 : static_cast<int>(std::ceil(kPredicted_m / options_.grid.resolution_m)));
  record->mutual_inlier_ratio = explanation.part();
  // Where new scans see little that is known, what they see through still speaks.
  const bool says_much = is_found || explanation.known >= 0.5 * options_.min_expected_overlap *
                                                              static_cast<double>(points.size());
  if (says_much && !Fits(record->mutual_inlier_ratio, options_.min_mutual_inlier_ratio,
                         world_T_nodes, scan_of_node, record->old_node, old_nodes)) {
    record->verdict = Verdict::kSeenThrough;
  }
}

bool Verifier::Fits(double inlier_ratio, double min_inlier_ratio,
                    const std::vector<SE2>& world_T_nodes, const ScanOfNode& scan_of_node, int node,
                    NodeRange around) const {
  if (inlier_ratio >= min_inlier_ratio) return true;
  if (inlier_ratio < kLeastUsual / kWellMapped * min_inlier_ratio) return false;
  const double usual =
      std::max(kLeastUsual, UsualInlierRatio(world_T_nodes, scan_of_node, around, node,
                                             options_.cell_m, options_.grid, gauss_newton_));
  return inlier_ratio >= usual / kWellMapped * min_inlier_ratio;
}

ClosureRecord Verifier::Compare(const std::vector<SE2>& world_T_nodes,
                                const ScanOfNode& scan_of_node, int node,
                                const Candidate& candidate, const Expectation& expectation) const {
  const int old = candidate.old_node;
  const SE2& expected = expectation.old_T_node;
  ClosureRecord record;
  record.old_node = old;
  record.node = node;
  record.path_length_m = candidate.path_length_m;
  record.distance_m = candidate.distance_m;
  const auto decided = [&record](Verdict verdict) {
    record.verdict = verdict;
    return record;
  };

  const NodeRange old_nodes = NodesAround(world_T_nodes, old, options_.old_reach_m);
  const NodeRange new_nodes = NodesAround(world_T_nodes, node, options_.new_reach_m);
  const scan_matching::ScanPoints points =
      JoinScans(world_T_nodes, scan_of_node, new_nodes, node, options_.cell_m);
  const map::OccupancyGrid map =
      BuildLocalMap(world_T_nodes, scan_of_node, old_nodes, old, options_.grid);
  const scan_matching::SearchWindow& window = expectation.window;
  record.overlap = Overlap(map, points, expected);
  if (window.linear_m <= kSmallWindow_m && record.overlap < options_.min_expected_overlap) {
    return decided(Verdict::kOverlap);
  }

  const scan_matching::CorrelativeMatcher search(
      SearchOptions(window), scan_matching::PositionsOf(JoinScans(
                                 world_T_nodes, scan_of_node, old_nodes, old, options_.cell_m)));
  const std::vector<Eigen::Vector2d> positions = scan_matching::PositionsOf(points);
  scan_matching::CorrelativeMatch coarse = search.Match(positions, expected, window);
  if (!coarse.found) return decided(Verdict::kNoMatch);
  if (IsAtBorder(window, expected, coarse.map_T_scan)) {
    const SE2 border = coarse.map_T_scan;
    const double runner_up_score = coarse.runner_up_score;
    coarse = search.Match(positions, border, kBeyondBorder);
    if (!coarse.found) return decided(Verdict::kNoMatch);
    coarse.runner_up_score = std::max(coarse.runner_up_score, runner_up_score);
    if (IsAtBorder(kBeyondBorder, border, coarse.map_T_scan)) return decided(Verdict::kUnstable);
  }
  record.score = coarse.score;
  record.runner_up_score = coarse.runner_up_score;
  record.old_T_node = coarse.map_T_scan;
  if (coarse.runner_up_score > options_.max_runner_up_score * coarse.score) {
    return decided(Verdict::kAmbiguous);
  }

  const scan_matching::GaussNewton::Alignment fine =
      gauss_newton_.Align(map, points, coarse.map_T_scan, scan_matching::GaussNewton::WeakPrior());
  const SE2 shift = Between(coarse.map_T_scan, fine.world_T_robot);
  record.old_T_node = fine.world_T_robot;
  if (shift.translation().norm() > options_.max_shift_m ||
      std::abs(shift.theta) > options_.max_shift_rad) {
    return decided(Verdict::kUnstable);
  }
  record.information = WithMapErrors(options_.information_gain * fine.world_information);

  record.overlap = Overlap(map, points, fine.world_T_robot);
  record.inlier_ratio = InlierRatio(map, points, fine);
  const SE2 estimated = Between(world_T_nodes[old], world_T_nodes[node]);
  record.mahalanobis_sq =
      drift_.SquaredDistance(Between(estimated, fine.world_T_robot), candidate.path_length_m);
  if (record.overlap < options_.min_overlap) return decided(Verdict::kOverlap);
  if (!Fits(record.inlier_ratio, options_.min_inlier_ratio, world_T_nodes, scan_of_node, node,
            new_nodes)) {
    return decided(Verdict::kInlierRatio);
  }
  return decided(Verdict::kUnconfirmed);
}

}  // namespace gmapping_spa::loop_closure
