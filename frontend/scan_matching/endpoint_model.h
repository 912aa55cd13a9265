// The measurement model p(z | m, x): how well the end points of a scan fit the hits of a map.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_

#include <vector>

#include "backend/se2.h"
#include "frontend/map/cell_block.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// One scan z and one map m, to be evaluated at many poses x near each other. A beam is explained by
// the nearest hit mean among the full cells of the 3 x 3 neighbourhood of its end point whose
// neighbour toward the laser is not full as well: a wall is seen from its own side. After Grisetti,
// Stachniss, Burgard 2007.
class EndpointModel {
 public:
  struct Options {
    double score_sigma_m = 0.05;         // of the score's kernel
    double likelihood_sigma_m = 0.05;    // of a beam's end point, map errors included
    double unmatched_distance_m = 0.25;  // an unexplained beam counts as this far from its hit
  };

  // `grid` and `points` must outlive this and stay as they are.
  EndpointModel(const Options& options, const map::OccupancyGrid* grid, const ScanPoints* points);

  double resolution_m() const { return grid_->resolution_m(); }

  // Mean over the beams of exp(-d^2 / 2 score_sigma^2), 0 for beams that nothing explains: 1 is a
  // perfect match. 0 for a scan without points. A score that turns out to be below `at_least` may
  // be given up half-way; what is returned then is below it, too.
  double Score(const backend::SE2& world_T_robot, double at_least = 0.0);

  // log p(z | m, x) up to a constant, in nats: sum over the beams of -d^2 / 2 likelihood_sigma^2,
  // with d limited to unmatched_distance_m.
  double LogLikelihood(const backend::SE2& world_T_robot);

 private:
  // Calls visit(k, d^2), in square cells, for every beam k that the map explains, until it returns
  // false.
  template <typename Visit>
  void ForEachExplainedBeam(const backend::SE2& world_T_robot, const Visit& visit);

  const map::OccupancyGrid* grid_;
  const ScanPoints* points_;
  std::vector<map::CellBlock> blocks_;  // around the end point of each beam
  double score_scale_;                  // the exponents per squared distance in cells
  double likelihood_scale_;
  double unmatched_squared_cells_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_
