// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/localization/place_guesses.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

#include "frontend/scan_matching/joined_points.h"
#include "frontend/scan_matching/seen_through.h"

namespace gmapping_spa::localization {

using backend::SE2;
using scan_matching::Evidence;

namespace {

// The middles of all occupied cells, in m.
std::vector<Eigen::Vector2d> SurfaceOf(const map::OccupancyGrid& map) {
  std::vector<Eigen::Vector2d> points;
  const map::OccupancyGrid::Extent extent = map.KnownExtent();
  for (int y = extent.min.y; y < extent.max.y; ++y) {
    for (int x = extent.min.x; x < extent.max.x; ++x) {
      if (map.OccupiedBits({x, y}) & 1u) {
        points.emplace_back((x + 0.5) * map.resolution_m(), (y + 0.5) * map.resolution_m());
      }
    }
  }
  return points;
}

// Of a pose before the views are aligned with the map.
constexpr double kSigma_m = 0.2;
constexpr double kSigma_rad = 0.1;

// Of a cell of the search: an alignment that starts 0.1 m off may end at the far side of a wall.
constexpr int kFinerSteps = 2;

}  // namespace

double PlaceGuess::Support() const {
  const double all = evidence.all();
  return all > 0.0 ? (evidence.explained - evidence.contradicted) / all : 0.0;
}

PlaceGuesses::PlaceGuesses(const Options& options, const map::OccupancyGrid* map)
    : options_(options), map_(map), gauss_newton_(options.gauss_newton) {
  const map::OccupancyGrid::Extent extent = map->KnownExtent();
  const double resolution_m = map->resolution_m();
  middle_ = {0.5 * (extent.min.x + extent.max.x) * resolution_m,
             0.5 * (extent.min.y + extent.max.y) * resolution_m, 0.0};
  reach_m_ =
      0.5 * std::max(extent.max.x - extent.min.x, extent.max.y - extent.min.y) * resolution_m;
  const double farthest_m = std::abs(middle_.x) + std::abs(middle_.y) + reach_m_;
  if (farthest_m >= options.cell_m * map::kMaxCellIndex) {
    throw std::runtime_error("expected a map that is not " + std::to_string(farthest_m) +
                             " m away from its origin");
  }
  scan_matching::CorrelativeMatcher::Options search;
  search.field = {.resolution_m = options.cell_m, .sigma_m = options.cell_m};
  search.pyramid_levels = 7;
  search.min_score = options.min_score;
  search.peak_separation_m = options.separation_m;
  search.peak_separation_rad = options.separation_rad;
  search.runner_up_floor = options.floor;
  search.with_covariance = false;
  matcher_ = std::make_unique<scan_matching::CorrelativeMatcher>(search, SurfaceOf(*map));
}

Evidence PlaceGuesses::EvidenceAt(const Views& views, const SE2& map_T_robot) const {
  Evidence sum;
  for (const Views::View& view : views.views()) {
    const SE2 map_T_view = map_T_robot * Between(views.odom_T_robot(), view.odom_T_robot);
    Evidence one =
        scan_matching::EndpointModel(options_.endpoint, map_, &view.points).Evaluate(map_T_view);
    const double behind = std::min(
        one.unknown, scan_matching::CountSeenThrough(*map_, view.points, map_T_view).into_unseen);
    sum.explained += one.explained;
    sum.contradicted += one.contradicted + behind;
    sum.unknown += one.unknown - behind;
    sum.at_surface += one.at_surface;
  }
  return sum;
}

Eigen::Matrix3d PlaceGuesses::InformationAt(const Views& views, const SE2& map_T_robot) const {
  return gauss_newton_.InformationAt(*map_, views.Joined(options_.align_cell_m), map_T_robot);
}

PlaceGuess PlaceGuesses::Near(const Views& views, const SE2& map_T_robot) const {
  return Aligned(views, views.Joined(options_.align_cell_m), map_T_robot);
}

PlaceGuess PlaceGuesses::Aligned(const Views& views, const scan_matching::ScanPoints& joined,
                                 const SE2& map_T_robot) const {
  const SE2 aligned =
      gauss_newton_
          .Align(*map_, joined, map_T_robot, backend::InformationFromSigmas(kSigma_m, kSigma_rad))
          .world_T_robot;
  return {.map_T_robot = aligned, .evidence = EvidenceAt(views, aligned)};
}

SE2 PlaceGuesses::Finer(const std::vector<Eigen::Vector2d>& points, const SE2& peak) const {
  const double turn_rad = 0.5 * matcher_->AngularStep(points);
  SE2 best = peak;
  int best_score = Score(points, peak);
  for (const double turn : {0.0, -turn_rad, turn_rad}) {
    for (int y = -kFinerSteps; y <= kFinerSteps; ++y) {
      for (int x = -kFinerSteps; x <= kFinerSteps; ++x) {
        const double step_m = options_.cell_m / kFinerSteps;
        const SE2 pose{peak.x + x * step_m, peak.y + y * step_m, peak.theta + turn};
        const int score = Score(points, pose);
        if (score > best_score) std::tie(best, best_score) = std::tuple(pose, score);
      }
    }
  }
  return best;
}

// Twice the points in an occupied cell and once those beside one.
int PlaceGuesses::Score(const std::vector<Eigen::Vector2d>& points, const SE2& map_T_robot) const {
  const double cells_per_m = 1.0 / map_->resolution_m();
  int score = 0;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d cell = cells_per_m * (map_T_robot * point);
    const int x = static_cast<int>(std::floor(cell.x())),
              y = static_cast<int>(std::floor(cell.y()));
    const std::uint32_t row = map_->OccupiedBits({x - 1, y});
    if (row & 0b010u) {
      score += 2;
    } else if (((row | map_->OccupiedBits({x - 1, y - 1}) | map_->OccupiedBits({x - 1, y + 1})) &
                0b111u) != 0) {
      score += 1;
    }
  }
  return score;
}

std::vector<PlaceGuess> PlaceGuesses::Find(const Views& views) const {
  const scan_matching::ScanPoints joined = views.Joined(options_.align_cell_m);
  const std::vector<Eigen::Vector2d> points = scan_matching::Thinned(
      scan_matching::PositionsOf(views.Joined(options_.cell_m)), options_.max_points);
  std::vector<PlaceGuess> guesses;
  for (const scan_matching::ScoredPose& peak :
       matcher_->Peaks(points, middle_, {reach_m_, std::numbers::pi}, options_.max_guesses)) {
    guesses.push_back(Aligned(views, joined, Finer(points, peak.map_T_scan)));
    guesses.back().score = peak.score;
  }
  std::stable_sort(guesses.begin(), guesses.end(), [](const PlaceGuess& a, const PlaceGuess& b) {
    return a.Support() > b.Support();
  });
  return guesses;
}

}  // namespace gmapping_spa::localization
