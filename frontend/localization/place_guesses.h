// SPDX-License-Identifier: BSD-3-Clause
// Where in a map a robot may be, by what it has seen.
#ifndef GMAPPING_SPA_FRONTEND_LOCALIZATION_PLACE_GUESSES_H_
#define GMAPPING_SPA_FRONTEND_LOCALIZATION_PLACE_GUESSES_H_

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "backend/se2.h"
#include "frontend/localization/views.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/correlative_matching.h"
#include "frontend/scan_matching/endpoint_model.h"
#include "frontend/scan_matching/gauss_newton.h"

namespace gmapping_spa::localization {

struct PlaceGuess {
  backend::SE2 map_T_robot;
  double score = 0.0;                // of the correlative match
  scan_matching::Evidence evidence;  // of all views

  // The part of the beams that the map explains less the part that it contradicts, -1 to 1.
  double Support() const;
};

// Searches a whole map, in all headings.
class PlaceGuesses {
 public:
  struct Options {
    double cell_m = 0.2;   // of the search
    int max_points = 150;  // that are searched with
    int max_guesses = 30;
    double min_score = 0.35;
    double floor = 0.7;         // part of the best score from which on others are guesses
    double separation_m = 0.5;  // nearer ones are the same
    double separation_rad = 0.2;
    double align_cell_m = 0.1;  // of what is aligned with the map
    scan_matching::EndpointModel::Options endpoint{.score_sigma_m = 0.1};
    scan_matching::GaussNewton::Options gauss_newton{.noise_sigma_m = 0.05};
    friend bool operator==(const Options&, const Options&) = default;
  };

  // `map` stays as it is and outlives this. Throws std::runtime_error where it is farther away from
  // its origin than a grid covers.
  PlaceGuesses(const Options& options, const map::OccupancyGrid* map);

  // The best ones by their evidence first.
  std::vector<PlaceGuess> Find(const Views& views) const;

  // Of all views together: GaussNewton::Alignment::world_information.
  Eigen::Matrix3d InformationAt(const Views& views, const backend::SE2& map_T_robot) const;

  // The place that is within decimetres of this one, where the views fit best; without a score.
  PlaceGuess Near(const Views& views, const backend::SE2& map_T_robot) const;

 private:
  // `joined`: end points of the views.
  PlaceGuess Aligned(const Views& views, const scan_matching::ScanPoints& joined,
                     const backend::SE2& map_T_robot) const;
  // Where the points fit best, of poses up to a cell of the search around its peak.
  backend::SE2 Finer(const std::vector<Eigen::Vector2d>& points, const backend::SE2& peak) const;
  int Score(const std::vector<Eigen::Vector2d>& points, const backend::SE2& map_T_robot) const;
  scan_matching::Evidence EvidenceAt(const Views& views, const backend::SE2& map_T_robot) const;

  Options options_;
  const map::OccupancyGrid* map_;
  scan_matching::GaussNewton gauss_newton_;
  std::unique_ptr<const scan_matching::CorrelativeMatcher> matcher_;
  backend::SE2 middle_;   // of the map
  double reach_m_ = 0.0;  // of the map from there, along x and y
};

}  // namespace gmapping_spa::localization

#endif  // GMAPPING_SPA_FRONTEND_LOCALIZATION_PLACE_GUESSES_H_
