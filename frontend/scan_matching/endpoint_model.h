// The measurement model p(z | m, x): how well the end points of a scan fit the hits of a map.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// A beam is explained by the nearest hit mean among the full cells of the 3 x 3 neighbourhood of
// its end point, provided that the cell in front of it, seen from the laser, is not full as well: a
// wall is seen from its own side. After Grisetti, Stachniss, Burgard 2007.
class EndpointModel {
 public:
  struct Options {
    double score_sigma_m = 0.158;      // of the score's kernel; wide, for a wide basin
    double likelihood_sigma_m = 0.1;   // of a beam's end point, map errors included
    double unmatched_distance_m = 0.25;  // an unexplained beam counts as this far from its hit
  };

  explicit EndpointModel(const Options& options);

  // Mean over the beams of exp(-d^2 / 2 score_sigma^2), 0 for beams that nothing explains: 1 is a
  // perfect match. 0 for a scan without points.
  double Score(const map::OccupancyGrid& grid, const ScanPoints& points,
               const backend::SE2& world_T_robot) const;

  // log p(z | m, x) up to a constant, in nats: sum over the beams of -d^2 / 2 likelihood_sigma^2,
  // with d limited to unmatched_distance_m.
  double LogLikelihood(const map::OccupancyGrid& grid, const ScanPoints& points,
                       const backend::SE2& world_T_robot) const;

 private:
  Options options_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_
