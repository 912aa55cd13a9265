// SPDX-License-Identifier: BSD-3-Clause
// Correlative scan matching: the best pose of a whole window, wherever the search starts.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_CORRELATIVE_MATCHING_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_CORRELATIVE_MATCHING_H_

#include <Eigen/Core>
#include <vector>

#include "backend/se2.h"
#include "frontend/scan_matching/field_pyramid.h"
#include "frontend/scan_matching/likelihood_field.h"
#include "frontend/scan_matching/pose_lattice.h"

namespace gmapping_spa::scan_matching {

// Half widths around the initial pose.
struct SearchWindow {
  double linear_m = 0.0;     // in the map's x and y, each
  double angular_rad = 0.0;  // at most pi
};

struct CorrelativeMatch {
  bool found = false;       // whether some pose reached min_score; if not, the rest is meaningless
  backend::SE2 map_T_scan;  // the best pose; of equally good ones that nearest to the initial pose
  double score = 0.0;       // there: mean over the points of the likelihood field, 0 to 1
  // Best score outside the peak of the best pose, or runner_up_floor times `score` if nothing
  // outside reaches that. The closer it is to `score`, the more ambiguous is the match.
  double runner_up_score = 0.0;
  backend::SE2 runner_up_map_T_scan;  // where that is; the best pose where nothing reaches it
  // Of (x, y, theta) in the frame of the map, from the scores of the peak as far as it lies in the
  // window, with weights exp(independent_points (score(pose) - score)). See ScorePeak. For small
  // distances the value of a point is 1 - d^2 / 2 sigma^2: the exponent is the log likelihood of so
  // many points, with a loss that saturates.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

struct ScoredPose {
  backend::SE2 map_T_scan;
  double score = 0.0;  // as of CorrelativeMatch
};

// Finds in a window the pose at which the points of a scan fit those of a reference best. It is
// exhaustive (Olson, "Real-time correlative scan matching", ICRA 2009) by best-first branch and
// bound on precomputed maxima (Hess et al., "Real-time loop closure in 2D lidar SLAM", ICRA 2016):
// no pose of the lattice that covers the window is better. Its steps are a cell of the field and
// AngularStep.
class CorrelativeMatcher {
 public:
  struct Options {
    LikelihoodFieldOptions field;
    int pyramid_levels = 6;
    double min_score = 0.5;
    // The peak of a pose: the poses that differ by no more than this in position and in angle.
    double peak_separation_m = 0.5;
    double peak_separation_rad = 0.1;
    // A second peak lower than this part of the best is not looked for: the lower, the longer the
    // search.
    double runner_up_floor = 0.7;
    // How many points say as much as all points together: neighbors share the errors of the map,
    // and the covariance must not shrink with the number of beams.
    double independent_points = 20.0;
    bool with_covariance = true;  // takes about as long as the search; otherwise it stays zero
    friend bool operator==(const Options&, const Options&) = default;
  };

  // `reference` in the frame of the map, in metres. See MakeLikelihoodField for preconditions.
  CorrelativeMatcher(const Options& options, const std::vector<Eigen::Vector2d>& reference);

  const Options& options() const { return options_; }

  // `points` in the frame of the scan, in metres. What is outside the field scores 0. Time grows
  // with their number: merge points closer to each other than a cell. Threads may share a matcher.
  CorrelativeMatch Match(const std::vector<Eigen::Vector2d>& points,
                         const backend::SE2& initial_map_T_scan, const SearchWindow& window) const;

  // The best poses of the window, each outside of the peaks of the better ones, the best first: at
  // most `count`, of scores down to runner_up_floor times that of the best, which reaches
  // min_score.
  std::vector<ScoredPose> Peaks(const std::vector<Eigen::Vector2d>& points,
                                const backend::SE2& initial_map_T_scan, const SearchWindow& window,
                                int count) const;

  // The step in angle by which the farthest point moves one cell (Olson 2009), but at most 0.05. In
  // radians. Precondition: no point is farther away than 10000 cells.
  double AngularStep(const std::vector<Eigen::Vector2d>& points) const;

 private:
  PoseLattice LatticeOf(const std::vector<Eigen::Vector2d>& points,
                        const backend::SE2& initial_map_T_scan, const SearchWindow& window) const;
  std::vector<PoseBlock> BestBlocks(const PoseLattice& lattice, double full_sum, int count) const;

  Options options_;
  FieldPyramid pyramid_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_CORRELATIVE_MATCHING_H_
