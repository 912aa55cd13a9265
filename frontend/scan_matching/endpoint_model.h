// SPDX-License-Identifier: BSD-3-Clause
// The measurement model p(z | m, x): how well the end points of a scan fit the hits of a map.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_

#include <cstddef>
#include <cstdint>

#include "backend/se2.h"
#include "frontend/map/beam_blocks.h"
#include "frontend/map/cell_block.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// What the beams of a scan say about a pose. A beam that ends at a surface of the map speaks for
// it, one that ends in free space or behind a surface against it. One that ends in unseen space
// is no evidence: counted as a miss it would pull the robot back to what is known. Beams count by
// their ScanPoint::weight.
struct Evidence {
  double explained = 0.0;     // sum over the beams at a surface of exp(-d^2 / 2 score_sigma^2)
  double contradicted = 0.0;  // number of beams
  double unknown = 0.0;       // number of beams
  double at_surface = 0.0;    // number of beams

  double known() const { return at_surface + contradicted; }
  double all() const { return known() + unknown; }
  // Between 0 and 1, the latter where nothing is known.
  double Fit() const { return known() > 0.0 ? explained / known() : 1.0; }
};

// One scan z and one map m, to be evaluated at many poses x near each other, in three ways:
//
// The score, for searching, is that of GMapping (Grisetti, Stachniss, Burgard 2007): a beam is
// explained by the nearest hit mean among the occupied cells of the 3 x 3 neighborhood of its end
// point whose neighbor toward the laser is not occupied as well: a wall is seen from its own side.
//
// The evidence, for comparing poses far from each other, is that sum with beams in unseen space
// left out.
//
// The likelihood, for weights and proposals, measures the distance to the surface that the hit
// means form (LocalSurface). It must not say more than the walls do: the nearest hit mean would
// hold a scan along a corridor by the spacing of cells, and so would the rule about the neighbor,
// which beams that graze a wall break at every other cell. GMapping takes the nearest hit mean all
// the same, that of the score.
class EndpointModel {
 public:
  enum class Likelihood : std::uint8_t {
    kSurface,    // distance to the LocalSurface
    kNearestHit  // distance to the hit mean that explains the beam in the score, as in GMapping
  };

  struct Options {
    double score_sigma_m = 0.05;       // of the score's kernel
    double likelihood_sigma_m = 0.03;  // of a beam's end point, map errors included
    double unmatched_sigmas = 5.0;     // at most this far off is a beam; farther is an outlier
    // Exponent of the likelihood. Neighboring beams see the same wall and the same error of the
    // map: their product would be too sure of itself.
    double likelihood_gain = 1.0 / 3.0;
    // Whether a beam that ends in unseen space is one that does not fit, for the likelihood, as in
    // GMapping.
    bool unseen_is_miss = false;
    Likelihood likelihood = Likelihood::kSurface;
    // Whether a hit explains a beam only where the cell before it, toward the laser, is not
    // occupied. GMapping's authors meant it so; in the program that they published the rule has no
    // effect.
    bool free_cell_in_front = true;
    friend bool operator==(const Options&, const Options&) = default;
  };

  // `grid` and `points` must outlive this and stay as they are.
  EndpointModel(const Options& options, const map::OccupancyGrid* grid, const ScanPoints* points);

  double resolution_m() const { return grid_->resolution_m(); }

  // Mean over the beams of exp(-d^2 / 2 score_sigma^2), 0 for beams that nothing explains: 1 is a
  // perfect match. 0 for a scan without points. A score that turns out to be below `at_least` may
  // be given up half-way; what is returned then is below it, too.
  double Score(const backend::SE2& world_T_robot, double at_least = 0.0);

  // What the beams say about the pose, told apart from where they are no evidence.
  Evidence Evaluate(const backend::SE2& world_T_robot);

  // log p(z | m, x) up to a constant, in nats: the gain times the sum over the beams of -d^2 / 2,
  // where d is the Mahalanobis distance to what Options::likelihood says with noise of
  // likelihood_sigma_m, limited to unmatched_sigmas. A beam that ends in unseen space counts as one
  // that fits as well as can be expected: it is no evidence against the pose. Of dense scans the
  // sum is estimated from beams that are spread evenly.
  double LogLikelihood(const backend::SE2& world_T_robot);

 private:
  // The end point of a beam at the pose that is evaluated.
  struct EndPoint {
    double x, y;  // in cells
    map::CellIndex cell;
    int back_dx, back_dy;  // the neighboring cell toward the laser
    const map::CellBlock* block;
    double back_x, back_y;  // unit vector toward the laser
  };

  // Calls visit(k, end point) for every `stride`-th beam k, until it returns false.
  template <typename Visit>
  void ForEachBeam(const backend::SE2& world_T_robot, std::size_t stride, const Visit& visit);

  // d^2 in cells to the nearest hit mean that explains the beam; infinite: none in reach.
  float SquaredDistanceToHit(const EndPoint& end) const;
  // exp(-d^2 / 2 score_sigma^2) of it; 0: none in reach.
  double Explained(const EndPoint& end) const;
  // d^2 of the likelihood, without limit; infinite: nothing in reach.
  float SquaredMahalanobis(const EndPoint& end) const;
  // Whether a beam without a surface in reach ends where no beam has been, without having crossed a
  // surface on its last decimetres.
  bool IsUnknown(const EndPoint& end) const;

  const map::OccupancyGrid* grid_;
  const ScanPoints* points_;
  map::BeamBlocks blocks_;
  double score_scale_;  // the exponent per squared distance in cells
  float noise_cells_;
  float max_squared_distance_;
  bool unseen_is_miss_;
  Likelihood likelihood_;
  bool free_cell_in_front_;
  double likelihood_scale_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_ENDPOINT_MODEL_H_
